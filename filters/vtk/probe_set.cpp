#include "filters/vtk/probe_set.h"

#include <algorithm>

#include "filters/vtk/capture_key.h"
#include "filters/vtk/probe_assignment.h"

namespace boxprobe {

namespace {

// Maps no probe uses any more are kept for undo up to this much GPU memory.
constexpr std::size_t kMapCacheBytes = std::size_t{256} << 20;
constexpr int kSkyFaceSize = 64;  // a gradient has no detail
constexpr int kSkyImageFaceSize = 256;

// Maps captured during a drag show at once but do not count as the final ones.
constexpr const char* kDuringDrag = "| during a drag";

bool lit(const DrawnObject& object) {
  return !object.unlit && object.settings.visible;
}

}  // namespace

ProbeSet::ProbeSet(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, CubeCapture* capture,
                   SceneContent* content, Times* times)
    : state_(std::move(state)), content_(content), capture_(capture), queue_(window, state_, capture, times) {}

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
    drawn.geometry = probeGeometry(probe, drawn.maps ? drawn.maps->capturedAt : probe.origin);
    entries_[i].used = std::any_of(content_->objects.begin(), content_->objects.end(), [&](const DrawnObject& object) {
      return lit(object) && influenceMeets(probe, worldBounds(object));
    });
  }
}

void ProbeSet::assignToObjects() {
  assign(!interactive_);
}

void ProbeSet::assign(bool newProgramsAllowed) {
  std::vector<std::shared_ptr<DrawnProbe>> drawn;
  for (const Entry& entry : entries_) drawn.push_back(entry.drawn);
  toPrepare_.clear();
  for (std::size_t i = 0; i < content_->objects.size(); ++i) {
    DrawnObject& object = content_->objects[i];
    auto binding = assignProbes(object, content_->scene, drawn, enabled_, interactive_);
    const std::string key = binding->variantKey();
    const ProbeBinding* current = object.mapper->GetBinding();
    // A box dragged over further objects would need programs that are not compiled yet; that waits for the drag's end.
    if (!newProgramsAllowed && current != nullptr && current->variantKey() != key && variantsUsed_.count(key) == 0)
      continue;
    variantsUsed_.insert(key);
    object.mapper->SetBinding(std::move(binding));
    if (editable_ && !interactive_) {
      auto general = assignProbes(object, content_->scene, drawn, enabled_, true);
      if (general->variantKey() != key) toPrepare_.emplace_back(i, std::move(general));
    }
  }
}

// Draws one object into a few pixels with the program a drag will need, so that it is compiled by then.
void ProbeSet::prepareOne() {
  auto [index, general] = std::move(toPrepare_.back());
  toPrepare_.pop_back();
  DrawnObject& object = content_->objects[index];
  if (!object.settings.visible || !prepared_.insert(general->variantKey() + object.materialName).second) return;
  const auto binding = object.mapper->GetSharedBinding();
  variantsUsed_.insert(general->variantKey());
  object.mapper->SetBinding(std::move(general));
  CaptureSettings settings;
  settings.originWorld = worldBounds(object).center();
  capture_->drawOnce(settings, {object.actor}, content_->lightPointers());
  object.mapper->SetBinding(binding);
}

void ProbeSet::updateCaptures() {
  const Scene& scene = content_->scene;
  const std::string shared = sharedCaptureKey(scene, content_->objects, content_->modelGeneration);
  std::vector<bool> used;
  for (const Entry& entry : entries_) used.push_back(entry.used);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    entry.wanted = captureKey(scene, i, used, shared);
    if (entry.wanted == entry.shown) continue;
    if (auto maps = cached(entry.wanted)) show(entry, scene.probes[i], entry.wanted, std::move(maps));
  }
  skyWanted_ = skyKey(scene);
  if (skyWanted_ != skyShown_) {
    if (auto maps = cached(skyWanted_)) {
      state_->sky = std::move(maps);
      skyShown_ = skyWanted_;
    }
  }
  startWork();
}

void ProbeSet::setInteractive(bool interactive) {
  if (interactive_ == interactive) return;
  interactive_ = interactive;
  assign(true);
  if (!interactive_) startWork();
}

void ProbeSet::setEnabled(bool enabled) {
  if (enabled_ == enabled) return;
  enabled_ = enabled;
  assignToObjects();
  startWork();
}

bool ProbeSet::stale() const {
  if (!enabled_) return false;
  if (skyWanted_ != skyShown_ && std::any_of(content_->objects.begin(), content_->objects.end(), lit)) return true;
  return std::any_of(entries_.begin(), entries_.end(), [this](const Entry& e) { return stale(e); });
}

bool ProbeSet::stale(const Entry& entry) const {
  return entry.used && entry.shown != entry.wanted && !(interactive_ && entry.shown == entry.wanted + kDuringDrag);
}

void ProbeSet::startWork() {
  if (!stale()) {
    queue_.abort();
    return;
  }
  std::vector<std::string> target;
  for (const Entry& entry : entries_) target.push_back(entry.wanted);
  target.push_back(skyWanted_);
  target.emplace_back(interactive_ ? "interactive" : "still");
  if (queue_.pending()) {
    if (target == queued_) return;
    // While something is dragged the capture under way is completed first: a picture a little late is better than none.
    if (interactive_ && queued_.back() == "interactive") return;
  }
  queued_ = std::move(target);
  std::vector<BakeItem> items;
  if (skyWanted_ != skyShown_) items.push_back(skyItem());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (stale(entries_[i])) items.push_back(probeItem(i));
  }
  queue_.start(std::move(items), content_->lightPointers(), interactive_);
}

BakeItem ProbeSet::skyItem() {
  BakeItem item;
  item.faceSize = content_->skyImage ? kSkyImageFaceSize : kSkyFaceSize;
  item.sky = true;
  // A sun of a few pixels must not fall between samples.
  item.settings.samplesPerTexelSide = content_->skyImage ? 4 : 1;
  item.props = {content_->sky};
  item.publish = [this, key = skyWanted_](std::shared_ptr<const ProbeMaps> maps) {
    state_->sky = maps;
    skyShown_ = key;
    remember(key, std::move(maps));
  };
  return item;
}

BakeItem ProbeSet::probeItem(std::size_t index) {
  const Probe& probe = content_->scene.probes[index];
  BakeItem item;
  item.settings.originWorld = probe.origin;
  item.settings.nearDistance = probe.nearDistance;
  item.settings.farDistance = probe.farDistance;
  item.settings.clear = probe.clear;
  item.settings.samplesPerTexelSide = samplesPerSide(probe.samplesPerPixel);
  item.faceSize = probe.faceSize;
  item.bounces = interactive_ ? 1 : probe.bounces;
  for (DrawnObject& object : content_->objects) {
    const bool hidden = std::find(probe.hides.begin(), probe.hides.end(), object.node) != probe.hides.end();
    if (object.settings.seenByProbes && !hidden) item.props.push_back(object.actor);
  }
  if (std::holds_alternative<ClearToSky>(probe.clear)) item.props.push_back(content_->sky);

  const std::string key = interactive_ ? entries_[index].wanted + kDuringDrag : entries_[index].wanted;
  item.publish = [this, key, name = probe.name, left = item.bounces](std::shared_ptr<const ProbeMaps> maps) mutable {
    const auto it = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
    if (it == entries_.end()) return;
    const bool last = --left == 0;
    // Maps of an earlier bounce have a key of their own: an undo in between must not take them for what was there
    // before.
    show(*it, content_->scene.probes[static_cast<std::size_t>(it - entries_.begin())],
         last ? key : key + "| " + std::to_string(left) + " bounces to go", maps);
    if (last && !interactive_) remember(key, std::move(maps));
  };
  return item;
}

void ProbeSet::show(Entry& entry, const Probe& probe, const std::string& key, std::shared_ptr<const ProbeMaps> maps) {
  entry.drawn->maps = std::move(maps);
  entry.drawn->geometry = probeGeometry(probe, entry.drawn->maps->capturedAt);
  entry.shown = key;
}

void ProbeSet::step() {
  if (!queue_.pending()) startWork();
  if (queue_.pending()) {
    queue_.step();
  } else if (preparationPending()) {
    prepareOne();
  }
}

std::shared_ptr<const ProbeMaps> ProbeSet::cached(const std::string& key) const {
  const auto it = std::find_if(cache_.begin(), cache_.end(), [&](const CachedMaps& c) { return c.key == key; });
  return it != cache_.end() ? it->maps : nullptr;
}

void ProbeSet::remember(const std::string& key, std::shared_ptr<const ProbeMaps> maps) {
  cache_.erase(std::remove_if(cache_.begin(), cache_.end(), [&](const CachedMaps& c) { return c.key == key; }),
               cache_.end());
  cache_.push_back({key, std::move(maps)});
  std::size_t bytes = memoryBytes();
  for (auto it = cache_.begin(); it != cache_.end() && bytes > kMapCacheBytes;) {
    if (it->maps.use_count() > 1) {  // a probe shows it
      ++it;
      continue;
    }
    bytes -= it->maps->bytes();
    it = cache_.erase(it);
  }
}

std::shared_ptr<const ProbeMaps> ProbeSet::maps(const std::string& probeName) const {
  for (const Entry& entry : entries_) {
    if (entry.name == probeName) return entry.drawn->maps;
  }
  return nullptr;
}

std::size_t ProbeSet::memoryBytes() const {
  std::size_t bytes = 0;
  for (const CachedMaps& entry : cache_) bytes += entry.maps->bytes();
  return bytes;
}

void ProbeSet::release() {
  queue_.release();
  cache_.clear();
  for (Entry& entry : entries_) {
    entry.drawn->maps.reset();
    entry.shown.clear();
  }
  state_->sky.reset();
  skyShown_.clear();
}

}  // namespace boxprobe
