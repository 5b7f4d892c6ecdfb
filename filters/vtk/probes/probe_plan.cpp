#include "filters/vtk/probes/probe_plan.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "filters/vtk/gl/map_bytes.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

// Up to this many probes, all are made at once, so that the camera may turn without waiting; of more, only those that
// light something in the frame.
constexpr std::size_t kAllAtOnce = 8;

using Views = std::unordered_set<std::string_view>;

Views viewsOf(const std::vector<std::string>& views) {
  return {views.begin(), views.end()};
}

constexpr int kSkyFaceSize = 64;  // a gradient has no detail
constexpr int kLargestSkyFaceSize = 256;

int skyFaceSize(int imageColumns) {
  int size = kSkyFaceSize;
  while (size < kLargestSkyFaceSize && 4 * size < imageColumns) size *= 2;
  return size;
}

/// The memory of all probes in use when complete, including existing maps, and of making them.
class MemoryNeed {
 public:
  /// `lattices`: its diffuse light is that of a lattice.
  void add(const Probe& probe, const CustomPictures& pictures, bool lattices);
  /// Of lamps, whose lattices are kept beside their texture, too.
  void addVisibilities(std::size_t bytes) { copies_ += bytes; }
  std::size_t bytes() const { return maps_ + latticesBytes() + scratch_; }
  /// One line that says what exceeds that many bytes, and what to reduce.
  std::string error(std::size_t limitBytes) const;

 private:
  std::size_t latticesBytes() const { return copies_ + latticeAtlasBytes(latticeCount_); }

  std::size_t maps_ = 0, scratch_ = 0, count_ = 0;
  std::size_t copies_ = 0, latticeCount_ = 0;  ///< of lattices; main memory, beside their texture
  int largest_ = 0;                            ///< face size, texels
};

void MemoryNeed::add(const Probe& probe, const CustomPictures& pictures, bool lattices) {
  const bool custom = probe.mode == ProbeMode::Custom;
  const auto picture = custom ? pictures.picture(probe.name) : nullptr;
  const int size = picture ? picture->faceSize() : probe.faceSize;
  // A further bounce is captured while the previous one lights the scene.
  maps_ += probeMapsBytes(size, !custom) * (probe.bounces > 1 && !custom ? 2 : 1);
  scratch_ = std::max(scratch_, captureScratchBytes(size));
  largest_ = std::max(largest_, size);
  ++count_;
  if (!lattices) return;
  copies_ += latticeBytes(probe);
  ++latticeCount_;
}

std::string MemoryNeed::error(std::size_t limitBytes) const {
  return "the maps of " + std::to_string(count_) + " probes with faces of up to " + std::to_string(largest_) +
         " texels " + (latticesBytes() > 0 ? "and " + memoryText(latticesBytes()) + " of lattices " : std::string()) +
         "need " + memoryText(bytes()) + " of texture memory, and there are " + memoryText(limitBytes) +
         " (BOXPROBE_TEXTURE_MEMORY, in MB, sets another limit); lower faceSize or bounces, or bake a share at a time "
         "(bake --shard)";
}

}  // namespace

std::optional<std::size_t> ProbeEntries::find(const std::string& name) const {
  const auto found = byName_.find(name);
  return found == byName_.end() ? std::nullopt : std::optional(found->second);
}

bool ProbeEntries::matched() const {
  const std::vector<Probe>& probes = scene_->probes;
  return std::equal(entries_.begin(), entries_.end(), probes.begin(), probes.end(),
                    [](const ProbeEntry& entry, const Probe& probe) { return entry.name == probe.name; });
}

std::optional<ProbeEntries::Origins> ProbeEntries::match() {
  places_ = ProbeIndex(scene_->probes);
  if (matched()) return std::nullopt;
  Origins origins;
  for (const Probe& probe : scene_->probes) origins.push_back(find(probe.name));
  follow(origins);
  return origins;
}

void ProbeEntries::follow(const Origins& origins) {
  places_ = ProbeIndex(scene_->probes);
  std::vector<ProbeEntry> next;
  byName_.clear();
  for (std::size_t i = 0; i < origins.size(); ++i) {
    next.push_back(origins[i] ? entries_[*origins[i]] : ProbeEntry{});
    next.back().name = scene_->probes[i].name;
    byName_.emplace(next.back().name, i);
  }
  entries_ = std::move(next);
}

void ProbeEntries::setUse(std::vector<ObjectUse> objects) {
  objects_ = std::move(objects);
  for (ProbeEntry& entry : entries_) entry.used = false;
  for (const ObjectUse& object : objects_) {
    for (const std::size_t probe : object.probes) entries_[probe].used |= object.lit;
  }
  findSeen();
}

bool ProbeEntries::setSeen(std::optional<std::vector<std::size_t>> objects) {
  seenObjects_ = std::move(objects);
  return findSeen();
}

bool ProbeEntries::findSeen() {
  const auto used = std::count_if(entries_.begin(), entries_.end(), [](const ProbeEntry& entry) { return entry.used; });
  const bool all = !seenObjects_ || static_cast<std::size_t>(used) <= kAllAtOnce;
  std::vector<bool> seen(entries_.size(), all);
  for (std::size_t i = 0; !all && i < seenObjects_->size(); ++i) {
    const std::size_t object = (*seenObjects_)[i];
    if (object >= objects_.size() || !objects_[object].lit) continue;  // not drawn with any probe yet
    for (const std::size_t probe : objects_[object].probes) seen[probe] = true;
  }
  bool changed = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    changed |= entries_[i].seen != seen[i];
    entries_[i].seen = seen[i];
  }
  return changed;
}

bool ProbeEntries::anyLit() const {
  return std::any_of(objects_.begin(), objects_.end(), [](const ObjectUse& object) { return object.lit; });
}

BounceKeys::BounceKeys(std::vector<Input> inputs) : inputs_(std::move(inputs)) {
  int most = 1;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    Input& input = inputs_[i];
    if (input.imported || input.realtime) input.bounces = 1;
    most = std::max(most, input.bounces);
    std::vector<std::size_t> sees;
    const Views known = input.record ? viewsOf(input.record->known) : Views();
    const Views seen = input.record ? viewsOf(input.record->sees) : Views();
    std::vector<bool> lights(inputs_.size(), false);
    for (const std::size_t other : input.lighting) lights[other] = true;
    for (std::size_t other = 0; other < inputs_.size() && !input.view.empty(); ++other) {
      if (inputs_[other].realtime || inputs_[other].view.empty()) continue;
      const std::string& view = inputs_[other].view;
      const bool told = !known.empty() && known.count(view) != 0;
      if (told ? seen.count(view) != 0 : lights[other]) sees.push_back(other);
    }
    sees_.push_back(std::move(sees));
    // Without the sky it is another picture than the only one of a single bounce.
    const bool withoutSky = input.latticeSky && input.several && !input.imported && !input.view.empty();
    keys_.push_back({withoutSky ? ContentHash().add(input.view).add("before the sky").text() : input.view});
  }
  for (int bounce = 2; bounce <= most; ++bounce) {
    // In the order of the keys: the list's order does not affect pictures. Thousands of probes may see one another.
    std::vector<std::string> texts(inputs_.size());
    std::vector<std::size_t> order(inputs_.size());
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      texts[i] = key(i, bounce - 1) + inputs_[i].drawn;
      order[i] = i;
    }
    std::sort(order.begin(), order.end(), [&texts](std::size_t a, std::size_t b) { return texts[a] < texts[b]; });
    std::vector<char> seen(inputs_.size(), 0);
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      if (bounce > inputs_[i].bounces) continue;
      ContentHash hash;
      hash.add(inputs_[i].view).add(inputs_[i].lattices ? "lit by lattices" : "lit by");
      for (const std::size_t other : sees_[i]) seen[other] = 1;
      for (const std::size_t other : order) {
        if (std::exchange(seen[other], 0) != 0) hash.add(texts[other]);
      }
      keys_[i].push_back(sees_[i].empty() && !inputs_[i].latticeSky ? inputs_[i].view : hash.text());
    }
  }
}

const std::string& BounceKeys::key(std::size_t probe, int bounce) const {
  const auto& keys = keys_[probe];
  return keys[std::min(static_cast<std::size_t>(bounce), keys.size()) - 1];
}

BakeRecord BounceKeys::record(std::size_t probe) const {
  BakeRecord record{finalKey(probe), inputs_[probe].view, {}, {}};
  // A single bounce shows no other probes; a record that grows with their number is only for several bounces.
  if (inputs_[probe].bounces < 2) return record;
  for (const std::size_t other : sees_[probe]) record.sees.push_back(inputs_[other].view);
  for (const Input& other : inputs_) {
    if (!other.view.empty()) record.known.push_back(other.view);
  }
  return record;
}

BounceKeys::Input ProbePlan::input(std::size_t index) const {
  const Probe& probe = entries_.probe(index);
  BounceKeys::Input input;
  if (const std::string& given = entries_[index].given; !given.empty()) {
    input.view = given;
    input.imported = true;  // the same at every bounce
    return input;
  }
  input.bounces = probe.bounces;
  input.lattices = world_.lattices;
  input.latticeSky = world_.nodesBringSky(probe);
  input.several = world_.several(probe);
  input.imported = probe.mode == ProbeMode::Custom;
  input.realtime = probe.mode == ProbeMode::Realtime;
  CaptureView view = probeView(world_, probe);
  input.view = input.imported ? sources_.pictures.key(probe) : view.key;
  input.lighting = std::move(view.lighting);
  if (followsBoxes_) {
    input.drawn = drawn_.at(probe.name);
  } else if (const auto it = records_.find(input.view); it != records_.end()) {
    input.record = it->second;
  } else {
    input.record = sources_.folder.record(input.view);
  }
  return input;
}

// For probes that are needed or exist already, and those that their further bounces show.
BounceKeys ProbePlan::askedBounces() const {
  const std::vector<Probe>& probes = entries_.scene().probes;
  std::vector<BounceKeys::Input> inputs(probes.size());
  std::vector<int> bounces(probes.size(), 0);  // requested up to this bounce
  std::vector<std::size_t> open;
  const auto ask = [&](std::size_t i, int upTo) {
    upTo = std::min(upTo, probes[i].bounces);
    if (upTo <= bounces[i]) return;
    bounces[i] = upTo;
    open.push_back(i);
  };
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const ProbeEntry& entry = entries_[i];
    const bool target = targets_.count(probes[i].name) != 0;
    if (entry.needed() || target || !entry.shown.empty() || probes[i].mode == ProbeMode::Realtime)
      ask(i, probes[i].bounces);
  }
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (inputs[i].view.empty()) inputs[i] = input(i);
    if (bounces[i] < 2) continue;
    for (const std::size_t other : inputs[i].lighting) ask(other, bounces[i] - 1);
    // Its inputs may be other probes than those that its box suggests now. And a file names all probes, whoever bakes a
    // part of them.
    const bool all = inputs[i].record || targets_.count(probes[i].name) != 0;
    for (std::size_t other = 0; all && other < probes.size(); ++other) ask(other, bounces[i] - 1);
  }
  return BounceKeys(std::move(inputs));
}

void ProbePlan::setWorld(CaptureWorld world) {
  const std::size_t probes = entries_.scene().probes.size();
  if (interactive_ && probes == worldProbes_ && world.objects.size() == world_.objects.size()) {
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
      world.objects[i].probes = std::move(world_.objects[i].probes);
    }
  }
  world.cutShort = std::move(world_.cutShort);
  world_ = std::move(world);
  worldProbes_ = probes;
}

void ProbePlan::updateDrawn() {
  if (!followsBoxes_) return;
  std::map<std::string, std::string> now;
  for (const Probe& probe : entries_.scene().probes) {
    const auto before = interactive_ ? drawn_.find(probe.name) : drawn_.end();
    now[probe.name] = before != drawn_.end() ? before->second : drawnKey(probe);
  }
  drawn_ = std::move(now);
}

void ProbePlan::updateKeys() {
  updateDrawn();
  bounces_ = askedBounces();
  // A record that no longer leads to maps is dropped: new maps follow the current boxes.
  bool dropped = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const std::string& key = bounces_.finalKey(i);
    if (key.empty() || !entries_.baked(i) || entries_[i].shown == key || showsSharp(i) || sources_.have(key)) continue;
    dropped |= records_.erase(bounces_.input(i).view) > 0;
  }
  if (dropped) bounces_ = askedBounces();

  for (std::size_t i = 0; i < entries_.size(); ++i) {
    ProbeEntry& entry = entries_[i];
    const Probe& probe = entries_.probe(i);
    const std::string before = entry.wanted;
    entry.asked = !bounces_.input(i).view.empty();
    if (!entry.asked) {
      entry.wanted.clear();
      continue;
    }
    if (probe.mode == ProbeMode::Realtime) {
      FaceKeys faces;
      for (std::size_t face = 0; face < 6; ++face) faces[face] = realtimeFaceKey(probe, static_cast<int>(face));
      entry.wanted = realtimeKey(probe, faces);
    } else {
      entry.wanted = bounces_.finalKey(i);
    }
    if (entry.wanted != before) entry.passes = bounces_.input(i).lighting.empty() ? 0 : probe.bounces - 1;
  }
}

// The first bounce has no light from probes, so it differs from a later one only where a probe would contribute.
std::string ProbePlan::faceKey(std::size_t index, int bounce, int face) const {
  const Probe& probe = entries_.probe(index);
  if (!keepsCapture(probe)) return {};
  const CaptureView view = faceView(world_, probe, face);
  std::vector<std::string> lighting;
  for (const std::size_t other : bounces_.sees(index)) {
    if (!std::binary_search(view.lighting.begin(), view.lighting.end(), other)) continue;
    lighting.push_back(bounce > 1 ? bounces_.key(other, bounce - 1) + bounces_.input(other).drawn : "none yet");
  }
  std::sort(lighting.begin(), lighting.end());
  ContentHash hash;
  hash.add(view.key);
  for (const std::string& key : lighting) hash.add(key);
  if (world_.lattices && bounce > 1 && !lighting.empty()) hash.add("by lattices");
  if (firstWithoutSky(index) && bounce == 1) hash.add("before the sky");
  return hash.text();
}

bool ProbePlan::firstWithoutSky(std::size_t index) const {
  const Probe& probe = entries_.probe(index);
  return world_.nodesBringSky(probe) && world_.several(probe);
}

std::string ProbePlan::realtimeFaceKey(const Probe& probe, int face) const {
  const CaptureView view = faceView(world_, probe, face);
  ContentHash hash;
  hash.add(view.key).add(probe.bounces > 1 ? (world_.lattices ? "lit by lattices" : "lit") : "dark");
  for (const std::size_t other : view.lighting) {
    if (probe.bounces < 2) continue;
    if (!bounces_.input(other).realtime) hash.add(bounces_.finalKey(other));
    hash.add(bounces_.input(other).drawn);
  }
  return hash.text();
}

std::string ProbePlan::realtimeKey(const Probe& probe, const FaceKeys& faces) {
  ContentHash hash;
  hash.add("realtime").add(static_cast<double>(probe.filter)).add(probe.filterSamples);
  for (const std::string& face : faces) hash.add(face);
  return hash.text();
}

void ProbePlan::remember(std::size_t index) {
  if (entries_.baked(index)) records_[bounces_.input(index).view] = bounces_.record(index);
}

void ProbePlan::wantSky(std::string key, int imageColumns) {
  skyWanted_ = std::move(key);
  skyImageColumns_ = imageColumns;
}

bool ProbePlan::stale(std::size_t index) const {
  const ProbeEntry& entry = entries_[index];
  if (entry.wanted.empty()) return false;
  if (!targets_.empty()) {
    if (targets_.count(entry.name) == 0 || !entries_.baked(index)) return false;
    return entry.shown != entry.wanted && !sources_.folder.has(entry.wanted);
  }
  if (!entry.needed()) return false;
  if (entries_.probe(index).mode == ProbeMode::Realtime) return entry.shown != entry.wanted || entry.passes > 0;
  return entry.shown != entry.wanted && !showsSharp(index) &&
         !(interactive_ && entry.shown == entry.wanted + kDuringDrag);
}

void ProbePlan::make() {
  jobs_.clear();
  memoryChecked_ = false;
  memoryError_.clear();
  if (!enabled_) return;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!stale(i)) continue;
    const Probe& p = entries_.probe(i);
    const std::string& wanted = entries_[i].wanted;
    if (p.mode == ProbeMode::Realtime) {
      jobs_.push_back({JobKind::Realtime, p.name, 1, {}, p.faceSize});
    } else if (p.mode == ProbeMode::Custom) {
      jobs_.push_back({JobKind::Picture, p.name, 1, wanted, sources_.pictures.picture(p.name)->faceSize()});
    } else if (interactive_) {
      jobs_.push_back({JobKind::Drag, p.name, 1, wanted + kDuringDrag, p.faceSize});
    }
  }
  if (!interactive_) planBounces();
  if (!interactive_ && targets_.empty()) planSharp();
  if (coarseFirst()) planCoarse();
  planSky();
}

bool ProbePlan::coarseFirst() const {
  if (!coarseFirst_ || !enabled_ || interactive_ || !targets_.empty()) return false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_.probe(i).mode == ProbeMode::Realtime) return false;
  }
  return true;
}

bool ProbePlan::coarsePending() const {
  const auto coarse = [](const ProbeJob& job) { return job.kind == JobKind::Coarse; };
  return (current_ && coarse(*current_)) || std::any_of(jobs_.begin(), jobs_.end(), coarse);
}

void ProbePlan::planCoarse() {
  std::vector<ProbeJob> coarse;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const ProbeEntry& entry = entries_[i];
    const Probe& p = entries_.probe(i);
    if (!entry.shown.empty() || !stale(i) || !entries_.baked(i) || sources_.have(entry.wanted)) continue;
    if (p.faceSize > kCoarseFaceSize)
      coarse.push_back({JobKind::Coarse, p.name, 1, entry.wanted + kCoarse, kCoarseFaceSize});
  }
  jobs_.insert(jobs_.begin(), coarse.begin(), coarse.end());
}

bool ProbePlan::showsSharp(std::size_t index) const {
  const ProbeEntry& entry = entries_[index];
  return !entry.wanted.empty() && sharp_.count(entry.name) != 0 && entry.shown.rfind(entry.wanted + kSharp, 0) == 0;
}

// After everything else, and only from bounces that are still there: nothing is captured for it but the probe itself.
void ProbePlan::planSharp() {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto asked = sharp_.find(entries_[i].name);
    const Probe& p = entries_.probe(i);
    const ProbeEntry& entry = entries_[i];
    if (asked == sharp_.end() || asked->second <= p.faceSize || !entries_.baked(i) || !entry.needed()) continue;
    const std::string key = entry.wanted + kSharp + std::to_string(asked->second);
    const bool final = entry.shown == entry.wanted || showsSharp(i);
    if (entry.wanted.empty() || !final || entry.shown == key || !entry.given.empty()) continue;
    bool complete = true;
    if (p.bounces > 1) {
      for (const std::size_t other : bounces_.sees(i)) complete &= sources_.cached(bounces_.key(other, p.bounces - 1));
    }
    if (complete) jobs_.push_back({JobKind::Sharp, p.name, p.bounces, key, asked->second});
  }
}

bool ProbePlan::bakesAny() const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (targets_.count(entries_[i].name) != 0 && entries_.baked(i)) return true;
  }
  return false;
}

void ProbePlan::planSky() {
  if (skyWanted_.empty() || !skyStale()) return;
  // Baked probes include the sky's file, which may be missing or damaged by itself.
  const bool asked =
      targets_.empty() ? entries_.anyLit() : !jobs_.empty() || (bakesAny() && !sources_.folder.has(skyWanted_));
  if (!asked) return;
  const int faceSize = skyFaceSize(skyImageColumns_);
  JobKind kind = JobKind::SkyMap;
  if (sources_.folder.has(skyWanted_)) {
    kind = JobKind::File;
  } else if (targets_.empty() && !sources_.skyLevels.empty() &&
             holdsSkyLevels(sources_.skyLevels, skyWanted_, faceSize)) {
    kind = JobKind::Levels;  // not for a bake, whose files record the capturing renderer
  }
  jobs_.insert(jobs_.begin(), {kind, {}, 1, skyWanted_, faceSize});
}

void ProbePlan::planBounces() {
  std::vector<std::pair<int, std::size_t>> missing;
  std::set<std::string> onDisk;
  const auto have = [&](const std::string& key) {
    if (key.empty() || sources_.cached(key)) return true;
    if (!sources_.folder.has(key)) return false;
    onDisk.insert(key);
    return true;
  };
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (stale(i) && entries_.baked(i)) bounces_.collect(i, entries_.probe(i).bounces, have, missing);
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    // Of the final maps, or of a bounce that others need first.
    const Probe& p = entries_.probe(i);
    for (int bounce = p.bounces; bounce >= 1 && !bounces_.input(i).view.empty(); --bounce) {
      const std::string& key = bounces_.key(i, bounce);
      if (onDisk.erase(key) != 0) jobs_.push_back({JobKind::File, p.name, bounce, key, p.faceSize});
    }
  }
  std::stable_sort(missing.begin(), missing.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [bounce, index] : missing) planBounce(index, bounce);
}

void ProbePlan::planBounce(std::size_t index, int bounce) {
  const Probe& p = entries_.probe(index);
  const std::string& key = bounces_.key(index, bounce);
  ProbeJob job{JobKind::Bounce, p.name, bounce, key, p.faceSize};
  if (bounces_.input(index).imported) {
    job.kind = JobKind::Picture;
    job.faceSize = sources_.pictures.picture(p.name)->faceSize();
  }
  if (std::find(jobs_.begin(), jobs_.end(), job) == jobs_.end()) jobs_.push_back(std::move(job));
}

bool ProbePlan::keepsCurrent() const {
  if (!current_ || !enabled_) return false;
  const auto index = entries_.find(current_->name);
  if (current_->kind == JobKind::Realtime) {
    return index && entries_.probe(*index).mode == ProbeMode::Realtime &&
           entries_.probe(*index).faceSize == current_->faceSize;
  }
  if (current_->kind == JobKind::Drag) return interactive_ && index && entries_.baked(*index);
  return std::find(jobs_.begin(), jobs_.end(), *current_) != jobs_.end();
}

bool ProbePlan::capturesLast() const {
  const auto lasts = [](const ProbeJob& job) {
    return job.kind != JobKind::Drag && job.kind != JobKind::Coarse && job.kind != JobKind::File &&
           job.kind != JobKind::Levels;
  };
  return std::any_of(jobs_.begin(), jobs_.end(), lasts) || (current_ && lasts(*current_));
}

bool ProbePlan::checkMemory(std::size_t limitBytes, std::size_t visibilityBytes) {
  memoryChecked_ = true;
  const auto asked = [&](std::size_t i) {
    const ProbeEntry& entry = entries_[i];
    return !entry.wanted.empty() && (targets_.empty() ? entry.needed() : targets_.count(entry.name) != 0);
  };
  MemoryNeed need;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (asked(i)) need.add(entries_.probe(i), sources_.pictures, world_.lattices && entries_.probe(i).hasLattice());
  }
  need.addVisibilities(visibilityBytes);
  memoryError_ = need.bytes() <= limitBytes ? std::string() : need.error(limitBytes);
  return memoryError_.empty();
}

BakeState ProbePlan::state(const std::string& probeName) const {
  const auto index = entries_.find(probeName);
  if (!index) return BakeState::NotUsed;
  const ProbeEntry& entry = entries_[*index];
  if (current_ && current_->name == probeName) return BakeState::Capturing;
  if (!entry.wanted.empty() && (entry.shown == entry.wanted || showsSharp(*index))) {
    return entry.fromFile ? BakeState::FromFile : BakeState::UpToDate;
  }
  if (!entry.needed() && targets_.count(probeName) == 0) return BakeState::NotUsed;
  if (sources_.folder.has(entry.wanted)) return BakeState::FromFile;
  return BakeState::Stale;
}

std::optional<BakeRecord> ProbePlan::record(const std::string& probeName) const {
  if (probeName.empty()) {
    if (skyShown_.empty() || skyStale()) return std::nullopt;
    return BakeRecord{skyShown_, skyShown_, {}, {}};
  }
  const auto index = entries_.find(probeName);
  if (!index || !entries_.baked(*index) || entries_[*index].shown != entries_[*index].wanted) {
    return std::nullopt;
  }
  return bounces_.record(*index);
}

}  // namespace boxprobe
