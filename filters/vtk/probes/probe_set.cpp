#include "filters/vtk/probes/probe_set.h"

#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/vtk/capture/prefilter.h"
#include "filters/vtk/gl/texture_memory.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

// Up to so many probes all are made at once, so that the camera may turn without waiting for them; of more, those that
// something in the frame is lit by.
constexpr std::size_t kAllAtOnce = 8;
constexpr int kSkyFaceSize = 64;  // a gradient has no detail
constexpr int kSkyImageFaceSize = 256;

// Maps captured during a drag show at once but do not count as the final ones.
constexpr const char* kDuringDrag = " during a drag";

bool lit(const DrawnObject& object) {
  return !object.unlit && object.settings.visible;
}

}  // namespace

// A picture of the user's has no capture origin: it belongs where the probe stands now.
ProbeGeometry ProbeSet::geometryOf(const Probe& probe, const ProbeMaps* maps) {
  if (maps == nullptr) return probeGeometry(probe, probe.origin, probe.rotationDegrees);
  const bool imported = probe.mode == ProbeMode::Custom;
  return probeGeometry(probe, imported ? probe.origin : maps->capturedAt, maps->capturedRotation);
}

ProbeSet::ProbeSet(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, CubeCapture* capture,
                   SceneContent* content, Times* times)
    : state_(std::move(state)), content_(content), capture_(capture), runner_(window, state_, capture, times) {}

std::optional<std::size_t> ProbeSet::find(const std::string& name) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].name == name) return i;
  }
  return std::nullopt;
}

// A probe keeps what it shows through a change of the list; a renamed one finds its maps again by key.
void ProbeSet::matchEntries() {
  const std::vector<Probe>& probes = content_->scene.probes;
  const bool same = std::equal(entries_.begin(), entries_.end(), probes.begin(), probes.end(),
                               [](const Entry& entry, const Probe& probe) { return entry.name == probe.name; });
  if (same) return;
  std::vector<Entry> next;
  for (const Probe& probe : probes) {
    const auto it =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == probe.name; });
    Entry entry;
    if (it != entries_.end()) entry = *it;
    entry.name = probe.name;
    next.push_back(std::move(entry));
  }
  entries_ = std::move(next);
}

void ProbeSet::updateShapes() {
  matchEntries();
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    DrawnProbe& drawn = *entries_[i].drawn;
    const Probe& probe = content_->scene.probes[i];
    drawn.index = static_cast<int>(i);
    drawn.geometry = geometryOf(probe, drawn.maps.get());
  }
  updateShadowLights();
  updateOpenings();  // the caller assigns
  index_ = ProbeIndex(content_->scene.probes);
}

// By what objects are drawn with: a probe that reaches an object but was left out of it lights nothing there.
void ProbeSet::findUsed() {
  for (Entry& entry : entries_) entry.used = false;
  for (const DrawnObject& object : content_->objects) {
    const ProbeBinding* binding = object.mapper->GetBinding();
    if (!lit(object) || binding == nullptr) continue;
    for (const auto& probe : binding->probes) entries_[static_cast<std::size_t>(probe->index)].used = true;
  }
  findSeen();
}

bool ProbeSet::findSeen() {
  const auto used = std::count_if(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.used; });
  const bool all = !seenObjects_ || static_cast<std::size_t>(used) <= kAllAtOnce;
  std::vector<bool> seen(entries_.size(), all);
  for (std::size_t i = 0; !all && i < seenObjects_->size(); ++i) {
    const DrawnObject& object = content_->objects[(*seenObjects_)[i]];
    if (!lit(object) || object.mapper->GetBinding() == nullptr) continue;
    for (const auto& probe : object.mapper->GetBinding()->probes) seen[static_cast<std::size_t>(probe->index)] = true;
  }
  bool changed = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    changed |= entries_[i].seen != seen[i];
    entries_[i].seen = seen[i];
  }
  return changed;
}

void ProbeSet::setSeen(std::optional<std::vector<std::size_t>> objects) {
  seenObjects_ = std::move(objects);
  if (!findSeen()) return;
  updateKeys();
  replan();
}

void ProbeSet::updateWorld() {
  if (contentGeneration_ != content_->modelGeneration) {
    contentKeys_ = objectContentKeys(content_->models, content_->scene.models.size());
    contentGeneration_ = content_->modelGeneration;
  }
  if (content_->skyImage != skyImage_.lock()) {
    skyImage_ = content_->skyImage;
    skyPixels_ = content_->skyImage ? imageContentKey(*content_->skyImage) : std::string();
  }
  world_ = captureWorld(content_->scene, content_->objects, contentKeys_, skyPixels_, index_);
  pictures_.update(content_->scene);
}

BounceKeys::Input ProbeSet::bounceInput(const Probe& probe) const {
  BounceKeys::Input input;
  input.bounces = probe.bounces;
  input.imported = probe.mode == ProbeMode::Custom;
  input.realtime = probe.mode == ProbeMode::Realtime;
  CaptureView view = probeView(world_, probe);
  input.view = input.imported ? pictures_.key(probe) : view.key;
  input.lighting = std::move(view.lighting);
  if (const auto it = records_.find(input.view); it != records_.end()) {
    input.record = it->second;
  } else {
    input.record = folder_.record(input.view);
  }
  return input;
}

// Only of probes that are wanted or there already, and of those that their further bounces show: what a probe shows is
// not even looked for as long as nobody asks.
BounceKeys ProbeSet::bounceKeys() const {
  const std::vector<Probe>& probes = content_->scene.probes;
  std::vector<BounceKeys::Input> inputs(probes.size());
  std::vector<int> bounces(probes.size(), 0);  // up to which it is asked for
  std::vector<std::size_t> open;
  const auto ask = [&](std::size_t i, int upTo) {
    upTo = std::min(upTo, probes[i].bounces);
    if (upTo <= bounces[i]) return;
    bounces[i] = upTo;
    open.push_back(i);
  };
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const bool target = targets_.count(probes[i].name) != 0;
    if (needed(i) || target || !entries_[i].shown.empty() || probes[i].mode == ProbeMode::Realtime)
      ask(i, probes[i].bounces);
  }
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (inputs[i].view.empty()) inputs[i] = bounceInput(probes[i]);
    if (bounces[i] < 2) continue;
    for (const std::size_t other : inputs[i].lighting) ask(other, bounces[i] - 1);
    // What it was made from may be other probes than those its boxes name now.
    for (std::size_t other = 0; inputs[i].record && other < probes.size(); ++other) ask(other, bounces[i] - 1);
  }
  return BounceKeys(std::move(inputs));
}

void ProbeSet::updateKeys() {
  keys_ = bounceKeys();
  // A record that no longer leads to maps has served: what is made now follows the boxes as they are now.
  bool dropped = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const std::string& key = keys_.finalKey(i);
    if (key.empty() || !baked(i) || entries_[i].shown == key || cache_.find(key) || folder_.has(key)) continue;
    dropped |= records_.erase(keys_.input(i).view) > 0;
  }
  if (dropped) keys_ = bounceKeys();

  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    const std::string before = entry.wanted;
    if (keys_.input(i).view.empty()) {
      entry.wanted.clear();
      continue;
    }
    entry.wanted =
        probe(i).mode == ProbeMode::Realtime ? realtimeKey(probe(i), realtimeFaces(probe(i))) : keys_.finalKey(i);
    if (entry.wanted != before) entry.passes = keys_.input(i).lighting.empty() ? 0 : probe(i).bounces - 1;
  }
}

void ProbeSet::showCached() {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    if (entry.wanted == entry.shown || entry.wanted.empty()) continue;
    if (auto maps = cache_.find(entry.wanted)) {
      show(i, entry.wanted, std::move(maps));
      entry.fromFile = false;
    }
  }
  if (skyWanted_ == skyShown_) return;
  if (auto maps = cache_.find(skyWanted_)) {
    state_->resources.sky = std::move(maps);
    skyShown_ = skyWanted_;
    showOpenings();
  }
}

void ProbeSet::updateCaptures() {
  updateWorld();
  updateKeys();
  skyWanted_ = world_.sky;
  replan();
}

void ProbeSet::setInteractive(bool interactive) {
  if (interactive_ == interactive) return;
  interactive_ = interactive;
  state_->setDragging(interactive);
  assign(true);
  replan();
}

void ProbeSet::setEnabled(bool enabled) {
  if (enabled_ == enabled) return;
  enabled_ = enabled;
  assignToObjects();
  replan();
}

void ProbeSet::setBakeTargets(const std::vector<std::string>& names) {
  targets_ = {names.begin(), names.end()};
  updateKeys();
  replan();
}

void ProbeSet::useBakedFiles(const std::string& folder) {
  folder_ = folder.empty() ? BakeFolder() : BakeFolder(folder);
  updateKeys();
  replan();
}

void ProbeSet::requestBake(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto index = find(name);
    if (!index) continue;
    Entry& entry = entries_[*index];
    if (baked(*index)) {
      for (int bounce = 1; bounce <= probe(*index).bounces; ++bounce) cache_.forget(keys_.key(*index, bounce));
      folder_.forget(entry.wanted);
      records_.erase(keys_.input(*index).view);
    }
    pictures_.forget(name);
    entry.shown = "made anew";
    entry.faces = {};
    entry.again = true;
  }
  runner_.abort();
  current_.reset();
  updateCaptures();
}

bool ProbeSet::stale(std::size_t index) const {
  const Entry& entry = entries_[index];
  if (entry.wanted.empty()) return false;
  if (!targets_.empty()) {
    if (targets_.count(entry.name) == 0 || !baked(index)) return false;
    return entry.shown != entry.wanted && !folder_.has(entry.wanted);
  }
  if (!needed(index)) return false;
  if (probe(index).mode == ProbeMode::Realtime) return entry.shown != entry.wanted || entry.passes > 0;
  return entry.shown != entry.wanted && !(interactive_ && entry.shown == entry.wanted + kDuringDrag);
}

BakeState ProbeSet::bakeState(const std::string& probeName) const {
  const auto index = find(probeName);
  if (!index) return BakeState::NotUsed;
  const Entry& entry = entries_[*index];
  if (current_ && current_->name == probeName) return BakeState::Capturing;
  if (!entry.wanted.empty() && entry.shown == entry.wanted) {
    return entry.fromFile ? BakeState::FromFile : BakeState::UpToDate;
  }
  if (!needed(*index) && targets_.count(probeName) == 0) return BakeState::NotUsed;
  if (folder_.has(entry.wanted)) return BakeState::FromFile;
  return BakeState::Stale;
}

std::optional<BakeRecord> ProbeSet::record(const std::string& probeName) const {
  if (probeName.empty()) {
    if (skyShown_.empty() || skyShown_ != skyWanted_) return std::nullopt;
    return BakeRecord{skyShown_, skyShown_, {}, {}};
  }
  const auto index = find(probeName);
  if (!index || !baked(*index) || entries_[*index].shown != entries_[*index].wanted) return std::nullopt;
  return keys_.record(*index);
}

// Work for everything that is stale, in the order in which it is done.
void ProbeSet::replan() {
  showCached();
  jobs_.clear();
  memoryChecked_ = false;
  memoryError_.clear();
  if (enabled_) {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (!stale(i)) continue;
      const Probe& p = probe(i);
      if (p.mode == ProbeMode::Realtime) {
        jobs_.push_back({JobKind::Realtime, p.name, 1, {}, p.faceSize});
      } else if (p.mode == ProbeMode::Custom) {
        jobs_.push_back({JobKind::Picture, p.name, 1, entries_[i].wanted, pictures_.picture(p.name)->faceSize()});
      } else if (interactive_) {
        jobs_.push_back({JobKind::Drag, p.name, 1, entries_[i].wanted + kDuringDrag, p.faceSize});
      }
    }
    if (!interactive_) planBounces();
    const bool wanted =
        targets_.empty() ? std::any_of(content_->objects.begin(), content_->objects.end(), lit) : !jobs_.empty();
    if (wanted && !skyWanted_.empty() && skyWanted_ != skyShown_) {
      const JobKind kind = folder_.has(skyWanted_) ? JobKind::File : JobKind::SkyMap;
      jobs_.insert(jobs_.begin(), {kind, {}, 1, skyWanted_, content_->skyImage ? kSkyImageFaceSize : kSkyFaceSize});
    }
  }
  if (jobs_.empty()) {
    kept_.clear();
    unitsDone_ = 0;
  }
  if (!keepsCurrent()) {
    runner_.abort();
    current_.reset();
  }
  if (moving_) updateStandIns();
}

void ProbeSet::planBounces() {
  std::vector<std::pair<int, std::size_t>> missing;
  std::set<std::string> onDisk;
  const auto have = [&](const std::string& key) {
    if (key.empty() || cache_.find(key)) return true;
    if (!folder_.has(key)) return false;
    onDisk.insert(key);
    return true;
  };
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (stale(i) && baked(i)) keys_.collect(i, probe(i).bounces, have, missing);
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (onDisk.count(keys_.finalKey(i)) == 0) continue;
    jobs_.push_back({JobKind::File, entries_[i].name, probe(i).bounces, keys_.finalKey(i), probe(i).faceSize});
    onDisk.erase(keys_.finalKey(i));
  }
  std::stable_sort(missing.begin(), missing.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [bounce, index] : missing) {
    const Probe& p = probe(index);
    const bool imported = keys_.input(index).imported;
    const Job job{imported ? JobKind::Picture : JobKind::Bounce, p.name, bounce, keys_.key(index, bounce),
                  imported ? pictures_.picture(p.name)->faceSize() : p.faceSize};
    if (std::find(jobs_.begin(), jobs_.end(), job) == jobs_.end()) jobs_.push_back(job);
  }
}

// May what is under way go on? A map that follows a drag or something that moves is completed, although the scene has
// moved on: a picture a little late is better than none.
bool ProbeSet::keepsCurrent() const {
  if (!current_ || !enabled_) return false;
  const auto index = find(current_->name);
  if (current_->kind == JobKind::Realtime) {
    return index && probe(*index).mode == ProbeMode::Realtime && probe(*index).faceSize == current_->faceSize;
  }
  if (current_->kind == JobKind::Drag) return interactive_ && index && baked(*index);
  return std::find(jobs_.begin(), jobs_.end(), *current_) != jobs_.end();
}

double ProbeSet::progress() const {
  if (jobs_.empty() && !runner_.pending()) return 1.0;
  int left = -runner_.unitsDone();
  for (const Job& job : jobs_) {
    left += job.kind == JobKind::File ? 1 : BakeRunner::units(job.faceSize, job.kind == JobKind::Realtime);
  }
  return static_cast<double>(unitsDone_) / std::max(unitsDone_ + left, 1);
}

// What all probes in use will hold in the end, those that are there already included, and what making them needs.
std::string ProbeSet::memoryProblem() const {
  std::size_t need = 0, scratch = 0, count = 0;
  int largest = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const bool wanted = targets_.empty() ? needed(i) : targets_.count(entries_[i].name) != 0;
    if (!wanted || entries_[i].wanted.empty()) continue;
    const bool custom = probe(i).mode == ProbeMode::Custom;
    const auto picture = custom ? pictures_.picture(probe(i).name) : nullptr;
    const int size = picture ? picture->faceSize() : probe(i).faceSize;
    const std::size_t bytes = probeMapsBytes(size, !custom);
    // A further bounce is captured while the one before it lights the scene.
    need += bytes * (probe(i).bounces > 1 && !custom ? 2 : 1);
    scratch = std::max(scratch, captureScratchBytes(size));
    largest = std::max(largest, size);
    ++count;
  }
  const std::size_t limit = textureMemoryLimit();
  if (need + scratch <= limit) return {};
  return "the maps of " + std::to_string(count) + " probes with faces of up to " + std::to_string(largest) +
         " texels need " + memoryText(need + scratch) + " of texture memory, and there are " + memoryText(limit) +
         " (BOXPROBE_TEXTURE_MEMORY, in MB, sets another limit); lower faceSize or bounces";
}

void ProbeSet::giveUp() {
  runner_.abort();
  current_.reset();
  jobs_.clear();
  toPrepare_.clear();
  kept_.clear();
  unitsDone_ = 0;
}

void ProbeSet::step() {
  if (!memoryChecked_ && !jobs_.empty()) {
    memoryChecked_ = true;
    memoryError_ = memoryProblem();
    if (!memoryError_.empty()) return giveUp();
  }
  if (!runner_.pending() && !jobs_.empty()) {
    const Job job = jobs_.front();
    begin(job);
    if (job.kind == JobKind::File) return;
  }
  if (runner_.pending()) {
    ++unitsDone_;
    runner_.step();
  } else if (const auto index = toMeasure()) {
    measureErrors(*index);
  } else if (preparationPending()) {
    prepareOne();
  }
}

void ProbeSet::show(std::size_t index, const std::string& key, std::shared_ptr<const ProbeMaps> maps) {
  Entry& entry = entries_[index];
  const bool turned = entry.drawn->geometry.mapTurned;
  entry.drawn->geometry = geometryOf(probe(index), maps.get());
  entry.drawn->maps = std::move(maps);
  // Another program, perhaps.
  if (updateOpenings() || entry.drawn->geometry.mapTurned != turned) assignToObjects();
  entry.shown = key;
  entry.faces = {};
}

std::shared_ptr<const ProbeMaps> ProbeSet::maps(const std::string& probeName) const {
  const auto index = find(probeName);
  return index ? entries_[*index].drawn->maps : nullptr;
}

std::size_t ProbeSet::memoryBytes() const {
  std::size_t bytes = cache_.bytes();
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto& maps = entries_[i].drawn->maps;
    if (maps && probe(i).mode == ProbeMode::Realtime) bytes += maps->bytes();
  }
  return bytes;
}

void ProbeSet::release() {
  runner_.release();
  current_.reset();
  kept_.clear();
  cache_.clear();
  for (Entry& entry : entries_) {
    entry.openSkyOf = {};
    entry.drawn->maps.reset();
    entry.shown.clear();
    entry.faces = {};
  }
  state_->resources.sky.reset();
  skyShown_.clear();
}

}  // namespace boxprobe
