// The probe set's work, one cubemap after another: what each shows, which faces can be kept, and what becomes of the
// finished maps. See probe_set.h.
#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/vtk/maps/content_hash.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/probes/probe_set.h"

namespace boxprobe {

namespace {

PrefilterSettings prefilterOf(const Probe& probe) {
  PrefilterSettings settings;
  if (probe.filter == FilterKind::Gaussian) settings.filter = FilterLobe::Kind::Gaussian;
  settings.samples = probe.filterSamples;
  return settings;
}

// Whether level 0 of a probe's maps holds its faces as they were captured: the frosty filter blurs it too.
bool keepsCapture(const Probe& probe) {
  return probe.filter == FilterKind::Ggx;
}

}  // namespace

void ProbeSet::begin(const Job& job) {
  if (job.kind == JobKind::File) {
    loadFile(job);
    return;
  }
  BakeItem item;
  switch (job.kind) {
    case JobKind::SkyMap:
      item = skyItem(job);
      break;
    case JobKind::Picture:
      item = pictureItem(job);
      break;
    case JobKind::Realtime:
      item = realtimeItem(job);
      break;
    default:
      item = captureItem(job);
  }
  item.faceSize = job.faceSize;
  item.bounce = job.bounce;
  if (const auto index = find(job.name)) item.prefilter = prefilterOf(probe(*index));
  runner_.start(std::move(item));
  current_ = job;
}

// A file that was damaged since it was looked at is as good as none: its probe is captured.
void ProbeSet::loadFile(const Job& job) {
  ++unitsDone_;
  try {
    auto maps = upload(folder_.load(job.key));
    FaceKeys faces;
    const auto index = find(job.name);
    for (int face = 0; index && face < 6; ++face) {
      faces[static_cast<std::size_t>(face)] = faceKey(*index, job.bounce, face);
    }
    ++state_->counts.counters.mapsLoaded;
    finish(job, std::move(faces), std::move(maps), true);
  } catch (const InputError&) {
    folder_.forget(job.key);
    updateCaptures();
  }
}

BakeItem ProbeSet::skyItem(const Job& job) {
  BakeItem item;
  item.sky = true;
  // A sun of a few pixels must not fall between samples.
  item.settings.samplesPerTexelSide = content_->skyImage ? 4 : 1;
  item.face = [this](int) { return FaceSource{nullptr, {content_->sky}, content_->lightPointers()}; };
  item.publish = [this, job](std::shared_ptr<const ProbeMaps> maps) { finish(job, {}, std::move(maps), false); };
  return item;
}

BakeItem ProbeSet::pictureItem(const Job& job) {
  BakeItem item;
  item.picture = pictures_.picture(job.name);
  if (const auto index = find(job.name)) item.settings.originWorld = probe(*index).origin;
  item.publish = [this, job](std::shared_ptr<const ProbeMaps> maps) { finish(job, {}, std::move(maps), false); };
  return item;
}

namespace {

CaptureSettings settingsOf(const Probe& probe) {
  CaptureSettings settings;
  settings.originWorld = probe.origin;
  settings.rotationDegrees = probe.rotationDegrees;
  settings.nearDistance = probe.nearDistance;
  settings.farDistance = probe.farDistance;
  settings.clear = probe.clear;
  settings.samplesPerTexelSide = samplesPerSide(probe.samplesPerPixel);
  return settings;
}

}  // namespace

FaceSource ProbeSet::faceSource(const Probe& probe, int face) const {
  FaceSource source;
  for (const std::size_t i : objectsInFace(world_, probe, face)) source.props.push_back(content_->objects[i].actor);
  if (std::holds_alternative<ClearToSky>(probe.clear)) source.props.push_back(content_->sky);
  source.lights = content_->lightPointers();
  return source;
}

// The first bounce shows no light from probes, so it differs from a later one only where a probe would throw some.
std::string ProbeSet::faceKey(std::size_t index, int bounce, int face) const {
  if (!keepsCapture(probe(index))) return {};  // no face to be used again
  const CaptureView view = faceView(world_, probe(index), face);
  std::vector<std::string> lighting;
  for (const std::size_t other : keys_.sees(index)) {
    if (!std::binary_search(view.lighting.begin(), view.lighting.end(), other)) continue;
    lighting.push_back(bounce > 1 ? keys_.key(other, bounce - 1) : "none yet");
  }
  std::sort(lighting.begin(), lighting.end());
  ContentHash hash;
  hash.add(view.key);
  for (const std::string& key : lighting) hash.add(key);
  return hash.text();
}

BakeItem ProbeSet::captureItem(const Job& job) {
  const std::size_t index = *find(job.name);
  const Probe& as = probe(index);
  const bool drag = job.kind == JobKind::Drag;
  BakeItem item;
  item.settings = settingsOf(as);
  item.reflectNothing = !drag && job.bounce == 1;
  if (!drag && job.bounce > 1) {
    item.drawing = [this, index, bounce = job.bounce](bool begins) { begins ? seeBounce(index, bounce) : seeAgain(); };
  }
  if (std::holds_alternative<ClearToOpen>(as.clear)) item.drawing = withoutSky(std::move(item.drawing));
  const auto faces = std::make_shared<FaceKeys>();
  item.face = [this, job, as, drag, faces](int face) {
    FaceSource source;
    const auto at = find(job.name);
    if (!drag && at) {
      std::string& key = (*faces)[static_cast<std::size_t>(face)];
      key = faceKey(*at, job.bounce, face);
      if (!entries_[*at].again) source.same = cache_.findFace(face, key);
    }
    return source.same ? source : faceSource(as, face);
  };
  item.publish = [this, job, faces](std::shared_ptr<const ProbeMaps> maps) {
    finish(job, *faces, std::move(maps), false);
  };
  return item;
}

// Every probe as it was captured a bounce before; null where that bounce does not show it. Realtime probes are not in
// anybody's bounces.
void ProbeSet::seeBounce(std::size_t of, int bounce) {
  windowSees_.clear();
  const std::vector<std::size_t>& sees = keys_.sees(of);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    DrawnProbe& drawn = *entries_[i].drawn;
    windowSees_.push_back({drawn.maps, drawn.geometry});
    const bool seen = std::find(sees.begin(), sees.end(), i) != sees.end();
    drawn.maps = seen ? cache_.find(keys_.key(i, bounce - 1)) : nullptr;
    drawn.geometry = geometryOf(probe(i), drawn.maps.get());
  }
}

void ProbeSet::seeAgain() {
  for (std::size_t i = 0; i < entries_.size() && i < windowSees_.size(); ++i) {
    entries_[i].drawn->maps = std::move(windowSees_[i].maps);
    entries_[i].drawn->geometry = windowSees_[i].geometry;
  }
  windowSees_.clear();
}

void ProbeSet::finish(const Job& job, FaceKeys faces, std::shared_ptr<const ProbeMaps> maps, bool fromFile) {
  current_.reset();
  if (job.name.empty()) {
    state_->resources.sky = maps;
    skyShown_ = job.key;
    showOpenings();
    cache_.add(job.key, {}, std::move(maps));
    replan();
    return;
  }
  const auto index = find(job.name);
  if (job.kind == JobKind::Drag) {
    // Dragged back to where it was: the final maps are there already.
    if (index) addTint(*index, *maps);
    if (index && entries_[*index].shown != entries_[*index].wanted) show(*index, job.key, std::move(maps));
    replan();
    return;
  }
  if (index) addTint(*index, *maps);
  // Maps of a bounce before the last are shown for the time being, but not in place of final ones.
  const bool last = index && job.key == entries_[*index].wanted;
  if (index && (last || stale(*index))) show(*index, job.key, maps);
  if (last) {
    entries_[*index].again = false;
    entries_[*index].fromFile = fromFile;
    if (baked(*index)) records_[keys_.input(*index).view] = keys_.record(*index);
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].wanted == job.key && entries_[i].shown != job.key) show(i, job.key, maps);
  }
  kept_.push_back(maps);
  cache_.add(job.key, std::move(faces), std::move(maps));
  replan();
}

std::string ProbeSet::realtimeFace(const Probe& probe, int face) const {
  const CaptureView view = faceView(world_, probe, face);
  ContentHash hash;
  hash.add(view.key).add(probe.bounces > 1 ? "lit" : "dark");
  for (const std::size_t other : view.lighting) {
    if (probe.bounces > 1 && !keys_.input(other).realtime) hash.add(keys_.finalKey(other));
  }
  return hash.text();
}

FaceKeys ProbeSet::realtimeFaces(const Probe& probe) const {
  FaceKeys faces;
  for (std::size_t face = 0; face < 6; ++face) faces[face] = realtimeFace(probe, static_cast<int>(face));
  return faces;
}

std::string ProbeSet::realtimeKey(const Probe& probe, const FaceKeys& faces) const {
  ContentHash hash;
  hash.add("realtime").add(static_cast<double>(probe.filter));
  for (const std::string& face : faces) hash.add(face);
  return hash.text();
}

// A realtime probe of several bounces sees the probes as they are, itself included, so each round adds a bounce: as
// many rounds as it has bounces after the last change, then it rests.
BakeItem ProbeSet::realtimeItem(const Job& job) {
  const std::size_t index = *find(job.name);
  const Probe as = probe(index);
  BakeItem item;
  item.settings = settingsOf(as);
  item.fewSteps = true;
  item.reflectNothing = as.bounces == 1;
  if (std::holds_alternative<ClearToOpen>(as.clear)) item.drawing = withoutSky({});
  const auto faces = std::make_shared<FaceKeys>();
  item.face = [this, as, faces](int face) {
    const auto at = find(as.name);
    const auto f = static_cast<std::size_t>(face);
    (*faces)[f] = realtimeFace(as, face);
    FaceSource source = faceSource(as, face);
    if (!at) return source;
    const Entry& entry = entries_[*at];
    const bool reflects = as.bounces > 1 && !faceView(world_, as, face).lighting.empty();
    if (!reflects && entry.faces[f] == (*faces)[f]) source.same = entry.drawn->maps;
    return source;
  };
  item.publish = [this, job, as, faces](std::shared_ptr<const ProbeMaps> maps) {
    finishRealtime(job, as, *faces, std::move(maps));
  };
  return item;
}

void ProbeSet::finishRealtime(const Job& job, const Probe& as, const FaceKeys& faces,
                              std::shared_ptr<const ProbeMaps> maps) {
  current_.reset();
  if (const auto index = find(job.name)) {
    Entry& entry = entries_[*index];
    const std::string key = realtimeKey(as, faces);
    if (key == entry.wanted && entry.shown == key && entry.passes > 0) --entry.passes;
    addTint(*index, *maps);
    show(*index, key, std::move(maps));
    entry.faces = keepsCapture(as) ? faces : FaceKeys{};
    entry.again = entry.fromFile = false;
  }
  replan();
}

}  // namespace boxprobe
