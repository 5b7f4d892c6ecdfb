#include "filters/vtk/probes/probe_baker.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_set>
#include <utility>

#include "filters/core/base/errors.h"
#include "filters/core/scene/bounces.h"
#include "filters/vtk/draw/program_tuning.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/probes/probe_binder.h"
#include "filters/vtk/probes/stand_in.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

namespace {

// Has a bounce changed less than a hundredth of what bounces after the first have brought, or next to nothing of all?
bool bouncesRest(const ShCoefficients& first, const ShCoefficients& before, const ShCoefficients& now) {
  constexpr double kNothing = 2.0e-4;
  double change = 0.0, brought = 0.0, whole = 0.0;
  const auto squared = [](const glm::vec3& v) { return static_cast<double>(glm::dot(v, v)); };
  for (std::size_t k = 0; k < now.size(); ++k) {
    change += squared(now[k] - before[k]);
    brought += squared(now[k] - first[k]);
    whole += squared(now[k]);
  }
  return std::sqrt(change) <= std::max(kBouncesAtRest * std::sqrt(brought), kNothing * std::sqrt(whole));
}

}  // namespace

void ProbeBaker::setWindow(vtkOpenGLRenderWindow* window) {
  graphics_.reset();
  if (window == nullptr) return;
  graphics_ = std::make_unique<Graphics>(window, with_.state, &times_);
}

void ProbeBaker::replan() {
  showCached();
  with_.plan->make();
  if (with_.plan->jobs().empty()) {
    earlier_.clear();
    firsts_.clear();
    unitsDone_ = 0;
    firstBouncePrograms_ = false;
  }
  if (!with_.plan->keepsCurrent()) abort();
  if (with_.state->tuning != nullptr) with_.state->tuning->replanned();
}

bool ProbeBaker::pending() const {
  return (graphics_ && graphics_->runner.pending()) || !with_.plan->jobs().empty();
}

bool ProbeBaker::standIn() {
  if (!with_.plan->coarseFirst()) return false;
  bool any = false;
  for (std::size_t i = 0; i < with_.plan->entries().size(); ++i) {
    const ProbeEntry& entry = with_.plan->entries()[i];
    if (!entry.shown.empty() || with_.binder->drawn(i).maps || !with_.plan->stale(i)) continue;
    const Probe& probe = with_.plan->entries().probe(i);
    with_.binder->show(i, upload(standInMaps(with_.content->scene, with_.content->skyImage.get(), probe), true));
    any = true;
  }
  return any;
}

bool ProbeBaker::step() {
  if (!graphics_->runner.pending() && !with_.plan->jobs().empty()) {
    const ProbeJob job = with_.plan->jobs().front();
    if (job.kind == JobKind::File || job.kind == JobKind::Levels) {
      load(job);
      return true;
    }
    begin(job);
  }
  if (!graphics_->runner.pending()) return false;
  ++unitsDone_;
  graphics_->runner.step();
  return true;
}

int ProbeBaker::unitsLeft() const {
  if (!pending()) return 0;
  int left = graphics_ ? -graphics_->runner.unitsDone() : 0;
  for (const ProbeJob& job : with_.plan->jobs()) {
    const bool read = job.kind == JobKind::File || job.kind == JobKind::Levels;
    const bool few = job.kind == JobKind::Realtime || job.kind == JobKind::Coarse;
    left += read ? 1 : BakeRunner::units(job.faceSize, few);
  }
  return std::max(left, 0);
}

void ProbeBaker::abort() {
  if (graphics_) graphics_->runner.abort();
  with_.plan->end();
}

void ProbeBaker::cancelWork() {
  abort();
  with_.plan->cancelWork();
  earlier_.clear();
  firsts_.clear();
  unitsDone_ = 0;
}

void ProbeBaker::release() {
  if (graphics_) graphics_->runner.release();
  if (graphics_) graphics_->capture.release();
  with_.plan->end();
  earlier_.clear();
  firsts_.clear();
  cache_.clear();
}

// Compiling programs for captures without reflections takes CPU time that a few faces do not recover. For files this
// counts the scene's probes, not those left to capture: shares of a bake must be bit-identical, and programs may round
// differently.
bool ProbeBaker::manyFirstBounces() const {
  constexpr int kWorthPrograms = 4;  // in probes
  if (!with_.plan->targets().empty()) {
    int baked = 0;
    for (std::size_t i = 0; i < with_.plan->entries().size(); ++i) baked += with_.plan->entries().baked(i) ? 1 : 0;
    return baked >= kWorthPrograms;
  }
  const auto first = [](const ProbeJob& job) { return job.kind == JobKind::Bounce && job.bounce == 1; };
  return std::count_if(with_.plan->jobs().begin(), with_.plan->jobs().end(), first) >= kWorthPrograms;
}

void ProbeBaker::begin(const ProbeJob& job) {
  firstBouncePrograms_ = firstBouncePrograms_ || manyFirstBounces();
  const auto faces = std::make_shared<FaceKeys>();
  BakeItem item = itemOf(job, faces);
  item.levels = [this, name = job.name](int levels) {
    if (name.empty()) return with_.binder->needs().ofSky(levels);
    const auto index = with_.plan->entries().find(name);
    return index ? with_.binder->needs().ofProbe(*index, levels) : kAllLevels;
  };
  item.faceSize = job.faceSize;
  item.bounce = job.bounce;
  item.firstBouncePrograms = firstBouncePrograms_ && job.kind == JobKind::Bounce && with_.state->tuning != nullptr;
  item.sight = [this, name = job.name]() -> std::shared_ptr<const ProbeSight> {
    const auto index = with_.plan->entries().find(name);
    return index && !name.empty() ? with_.binder->drawn(*index).captureSight : nullptr;
  };
  Probe as;  // its state when its capture started
  if (const auto index = with_.plan->entries().find(job.name)) {
    as = with_.plan->entries().probe(*index);
    item.prefilter = prefilterSettings(as);
  }
  item.publish = [this, job, as, faces](std::shared_ptr<const ProbeMaps> maps) {
    MadeMaps made{job, *faces, std::move(maps)};
    if (job.kind == JobKind::Realtime) {
      made.job.key = ProbePlan::realtimeKey(as, *faces);
      if (!keepsCapture(as)) made.faces = {};
    }
    finish(std::move(made));
  };
  graphics_->runner.start(std::move(item));
  with_.plan->begin(job);
}

BakeItem ProbeBaker::itemOf(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces) {
  switch (job.kind) {
    case JobKind::SkyMap:
      return sky();
    case JobKind::Picture:
      return picture(job);
    case JobKind::Realtime:
      return realtime(job, faces);
    default:
      return bounce(job, faces);
  }
}

BakeItem ProbeBaker::sky() const {
  BakeItem item;
  item.sky = true;
  // Samples must not miss a sun of a few pixels.
  item.settings.samplesPerTexelSide = with_.plan->skyIsImage() ? 4 : 1;
  item.face = [this](int) {
    vtkSkyProp* light = with_.content->skyLight;
    return FaceSource{nullptr, {light != nullptr ? light : with_.content->sky.Get()}, with_.content->lightPointers()};
  };
  return item;
}

BakeItem ProbeBaker::picture(const ProbeJob& job) const {
  BakeItem item;
  item.picture = with_.plan->sources().pictures.picture(job.name);
  if (const auto index = with_.plan->entries().find(job.name)) {
    item.settings.originWorld = with_.plan->entries().probe(*index).origin;
  }
  return item;
}

// Nearest first, by the farthest point of their bounds as in the window (vtkCulledRenderer), so that fragments hidden
// by walls are not shaded.
FaceSource ProbeBaker::faceSource(const Probe& probe, int face) const {
  const CaptureWorld& world = with_.plan->world();
  FaceSource source;
  std::vector<std::pair<double, vtkProp*>> order;
  for (const std::size_t i : objectsInFace(world, probe, face)) {
    const Box& bounds = world.objects[i].boundsWorld;
    const glm::dvec3 away = glm::max(glm::abs(bounds.min - probe.origin), glm::abs(bounds.max - probe.origin));
    if (vtkProp* prop = props_[i]) order.emplace_back(glm::dot(away, away), prop);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::unordered_set<vtkProp*> taken;  // parts of an assembly are drawn together with it
  for (const auto& object : order) {
    if (taken.insert(object.second).second) source.props.push_back(object.second);
  }
  source.objects = source.props.size();
  source.culled = props_.size() - source.objects;
  if (std::holds_alternative<ClearToSky>(probe.clear)) source.props.push_back(with_.content->sky);
  source.lights = with_.content->lightPointers();
  return source;
}

BakeItem ProbeBaker::bounce(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces) {
  const Probe as = with_.plan->entries().probe(*with_.plan->entries().find(job.name));
  const bool coarse = job.kind == JobKind::Coarse, drag = job.kind == JobKind::Drag || coarse;
  const bool sharp = job.kind == JobKind::Sharp;  // of other texels than the faces that are known
  BakeItem item;
  item.settings = captureSettings(as);
  item.coarse = item.fewSteps = coarse;
  if (coarse) item.settings.samplesPerTexelSide = 1;
  item.reflectNothing = !drag && job.bounce == 1;
  if (!drag && job.bounce > 1) {
    item.drawing = [this, job](bool begins) { begins ? seeBounce(job) : with_.binder->seeAgain(); };
  }
  // A sky that nothing hides would shine into rooms; nodes of lattices know what hides it.
  const bool traced = !drag && with_.plan->world().nodesBringSky(as);
  const bool first = traced && job.bounce == 1 && with_.plan->firstWithoutSky(*with_.plan->entries().find(job.name));
  const bool open = std::holds_alternative<ClearToOpen>(as.clear) && !(traced && job.bounce > 1);
  if (open || first) item.drawing = with_.binder->withoutSky(std::move(item.drawing));
  item.face = [this, job, as, drag, sharp, faces](int face) {
    FaceSource source;
    const auto at = with_.plan->entries().find(job.name);
    if (!drag && !sharp && at) {
      std::string& key = (*faces)[static_cast<std::size_t>(face)];
      key = with_.plan->faceKey(*at, job.bounce, face);
      if (!with_.plan->entries()[*at].again) source.same = cache_.findFace(face, key);
    }
    return source.same ? source : faceSource(as, face);
  };
  return item;
}

// Shows every probe as captured one bounce earlier; null where that bounce does not use it. Realtime probes are in no
// other probe's bounces.
void ProbeBaker::seeBounce(const ProbeJob& job) const {
  const auto of = with_.plan->entries().find(job.name);  // the list may have changed since the job started
  if (!of) return;
  const BounceKeys& bounces = with_.plan->bounces();
  const std::vector<std::size_t>& sees = bounces.sees(*of);
  with_.binder->see([&](std::size_t i) -> std::shared_ptr<const ProbeMaps> {
    const bool seen = std::find(sees.begin(), sees.end(), i) != sees.end();
    const std::shared_ptr<const ProbeMaps> maps = seen ? cache_.find(bounces.key(i, job.bounce - 1)) : nullptr;
    // These maps are not shown, so nothing else tracks which levels of them are sampled; and they may be older than the
    // materials.
    if (maps) maps->need(with_.binder->needs().ofProbe(i, maps->radiance.levels()));
    return maps;
  });
}

// A realtime probe of several bounces sees the current maps of probes, including its own, so each round adds a bounce.
// It rests after as many rounds as it has bounces since the last change.
BakeItem ProbeBaker::realtime(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces) {
  const Probe as = with_.plan->entries().probe(*with_.plan->entries().find(job.name));
  BakeItem item;
  item.settings = captureSettings(as);
  item.fewSteps = true;
  item.reflectNothing = as.bounces == 1;
  if (std::holds_alternative<ClearToOpen>(as.clear)) item.drawing = with_.binder->withoutSky({});
  item.face = [this, as, faces](int face) {
    const auto at = with_.plan->entries().find(as.name);
    const auto f = static_cast<std::size_t>(face);
    (*faces)[f] = with_.plan->realtimeFaceKey(as, face);
    FaceSource source = faceSource(as, face);
    if (!at) return source;
    const bool reflects = as.bounces > 1 && !faceView(with_.plan->world(), as, face).lighting.empty();
    if (!reflects && with_.plan->entries()[*at].faces[f] == (*faces)[f]) source.same = with_.binder->drawn(*at).maps;
    return source;
  };
  return item;
}

// If a file was damaged since it was checked, its probe or the sky is captured instead.
void ProbeBaker::load(const ProbeJob& job) {
  ++unitsDone_;
  MadeMaps made{job, {}, nullptr, true};
  try {
    made.maps = job.kind == JobKind::Levels ? upload(loadSkyLevels(with_.plan->sources().skyLevels))
                                            : upload(with_.plan->sources().folder.load(job.key));
  } catch (const InputError& damage) {
    if (job.kind == JobKind::Levels) {
      with_.plan->sources().skyLevels.clear();
    } else {
      with_.plan->sources().folder.forget(job.key, damage.what());
      with_.plan->updateKeys();
    }
    return replan();
  }
  const auto index = with_.plan->entries().find(job.name);
  for (int face = 0; index && face < 6; ++face) {
    made.faces[static_cast<std::size_t>(face)] = with_.plan->faceKey(*index, job.bounce, face);
  }
  ++with_.state->counts.counters.mapsLoaded;
  finish(std::move(made));
}

void ProbeBaker::finish(MadeMaps made) {
  with_.plan->end();
  if (made.job.name.empty()) {
    showSky(made.job.key, made.maps);
    cache_.add(made.job.key, {}, std::move(made.maps));
  } else if (made.job.kind == JobKind::Drag) {
    publishDrag(std::move(made));
  } else if (made.job.kind == JobKind::Coarse) {
    publishCoarse(std::move(made));
  } else if (made.job.kind == JobKind::Sharp) {
    publishSharp(std::move(made));
  } else if (made.job.kind == JobKind::Realtime) {
    publishRealtime(std::move(made));
  } else {
    publishFinal(std::move(made));
  }
  replan();
  if (endBounces()) replan();
}

void ProbeBaker::publishDrag(MadeMaps made) {
  const auto index = with_.plan->entries().find(made.job.name);
  if (!index) return;
  with_.binder->addTint(*index, *made.maps);
  // Dragged back to the original position: the final maps exist.
  const ProbeEntry& entry = with_.plan->entries()[*index];
  if (entry.shown != entry.wanted) show(*index, made.job.key, std::move(made.maps));
}

void ProbeBaker::publishCoarse(MadeMaps made) {
  const auto index = with_.plan->entries().find(made.job.name);
  if (!index) return;
  with_.binder->addTint(*index, *made.maps);
  if (with_.plan->entries()[*index].shown.empty()) show(*index, made.job.key, std::move(made.maps));
}

// Not kept for undo: the maps of the scene's own size are.
void ProbeBaker::publishSharp(MadeMaps made) {
  const auto index = with_.plan->entries().find(made.job.name);
  if (!index || made.job.key.rfind(with_.plan->entries()[*index].wanted + kSharp, 0) != 0) return;
  with_.binder->addTint(*index, *made.maps);
  show(*index, made.job.key, std::move(made.maps));
}

void ProbeBaker::publishRealtime(MadeMaps made) {
  const auto index = with_.plan->entries().find(made.job.name);
  if (!index) return;
  ProbeEntry& entry = with_.plan->entries()[*index];
  const std::string& key = made.job.key;
  if (key == entry.wanted && entry.shown == key && entry.passes > 0) --entry.passes;
  with_.binder->addTint(*index, *made.maps);
  show(*index, key, std::move(made.maps));
  entry.faces = std::move(made.faces);
  entry.again = entry.fromFile = false;
}

void ProbeBaker::publishFinal(MadeMaps made) {
  const std::string& key = made.job.key;
  ProbeEntries& entries = with_.plan->entries();
  const auto index = entries.find(made.job.name);
  if (index) with_.binder->addTint(*index, *made.maps);
  // Maps of an earlier bounce are shown temporarily, but do not replace final ones.
  const bool last = index && key == entries[*index].wanted;
  if (index && (last || with_.plan->stale(*index))) show(*index, key, made.maps);
  if (last) {
    entries[*index].again = false;
    entries[*index].fromFile = made.fromFile;
    with_.plan->remember(*index);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].wanted != key || with_.plan->showsSharp(i)) continue;
    if (entries[i].shown != key) show(i, key, made.maps);
  }
  dropEarlier(made.job.bounce);
  if (made.job.bounce == 1) firsts_[key] = made.maps->irradiance;
  earlier_.emplace_back(key, made.maps);
  cache_.add(key, std::move(made.faces), std::move(made.maps));
}

// A bounce is made from the one before it: what neither of the two shows is no longer held.
void ProbeBaker::dropEarlier(int bounce) {
  const BounceKeys& keys = with_.plan->bounces();
  std::unordered_set<std::string> held;
  for (std::size_t i = 0; i < with_.plan->entries().size(); ++i) {
    if (keys.input(i).view.empty()) continue;
    held.insert(keys.key(i, bounce));
    held.insert(keys.key(i, std::max(bounce - 1, 1)));
  }
  const auto gone = [&](const auto& earlier) { return held.count(earlier.first) == 0; };
  earlier_.erase(std::remove_if(earlier_.begin(), earlier_.end(), gone), earlier_.end());
}

// Of probes that ask for all bounces: once none that is being made changes any more, the last ones are the final ones.
// Light comes one room farther with each bounce, so that what still changes anywhere counts for all.
bool ProbeBaker::endBounces() {
  ProbeEntries& entries = with_.plan->entries();
  const BounceKeys& keys = with_.plan->bounces();
  std::vector<std::size_t> open;
  int made = kAllBounces;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!entries.baked(i) || !allBounces(entries.probe(i))) continue;
    const auto waits = [&](const ProbeJob& job) { return job.kind == JobKind::Bounce && job.name == entries[i].name; };
    const auto& jobs = with_.plan->jobs();
    if (std::none_of(jobs.begin(), jobs.end(), waits)) continue;
    int last = kAllBounces - 1;
    while (last > 0 && !cache_.find(keys.key(i, last))) --last;
    open.push_back(i);
    made = std::min(made, last);
  }
  if (open.empty() || made < 2) return false;
  for (const std::size_t i : open) {
    const auto before = cache_.find(keys.key(i, made - 1)), now = cache_.find(keys.key(i, made));
    if (!before || !now) return false;
    const auto first = firsts_.find(keys.key(i, 1));
    if (!bouncesRest(first == firsts_.end() ? ShCoefficients{} : first->second, before->irradiance, now->irradiance)) {
      return false;
    }
  }
  for (const std::size_t i : open) {
    for (const int bounce : {kAllBounces - 1, kAllBounces}) {
      const auto maps = cache_.find(keys.key(i, bounce == kAllBounces ? made : made - 1));
      earlier_.emplace_back(keys.key(i, bounce), maps);
      cache_.add(keys.key(i, bounce), {}, maps);
    }
    entries[i].again = entries[i].fromFile = false;
    if (entries[i].wanted == keys.finalKey(i)) with_.plan->remember(i);
  }
  return true;
}

// Shows maps made earlier for all probes and the sky.
void ProbeBaker::showCached() {
  ProbeEntries& entries = with_.plan->entries();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    ProbeEntry& entry = entries[i];
    if (entry.wanted == entry.shown || entry.wanted.empty() || with_.plan->showsSharp(i)) continue;
    if (auto maps = cache_.find(entry.wanted)) {
      show(i, entry.wanted, std::move(maps));
      entry.fromFile = false;
    }
  }
  if (!with_.plan->skyStale()) return;
  if (auto maps = cache_.find(with_.plan->skyWanted())) showSky(with_.plan->skyWanted(), std::move(maps));
}

void ProbeBaker::show(std::size_t index, const std::string& key, std::shared_ptr<const ProbeMaps> maps) {
  ProbeEntry& entry = with_.plan->entries()[index];
  entry.shown = key;
  entry.faces = {};
  with_.binder->show(index, std::move(maps));
}

void ProbeBaker::showSky(const std::string& key, std::shared_ptr<const ProbeMaps> maps) {
  with_.plan->skyShows(key);
  with_.binder->showSky(std::move(maps));
}

}  // namespace boxprobe
