#include "filters/vtk/probes/probe_set.h"

#include <algorithm>

#include "filters/vtk/gl/texture_memory.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

namespace {

// GPU memory for unused maps.
constexpr std::size_t kKeptForUndo = std::size_t{256} << 20;

}  // namespace

ProbeSet::ProbeSet(SceneContent* content, const std::shared_ptr<DrawState>& state)
    : with_{content, state, &plan_, &binder_, &baker_},
      plan_(&content->scene, [this](const std::string& key) { return baker_.cache().find(key) != nullptr; }),
      baker_(with_, kKeptForUndo),
      binder_(with_),
      tuning_(with_) {
  state->tuning = &tuning_;
}

ProbeSet::~ProbeSet() {
  if (with_.state->tuning == &tuning_) with_.state->tuning = nullptr;  // actors may outlive this object
}

void ProbeSet::setTuned(bool tuned) {
  if (tuned == (with_.state->tuning != nullptr)) return;
  with_.state->tuning = tuned ? &tuning_ : nullptr;
  if (tuned && plan_.entries().matched()) binder_.assign();
}

ProbeSet::ProbeSet(SceneContent* content, const std::shared_ptr<DrawState>& state, const Scene* captured)
    : with_{content, state, &plan_, &binder_, &baker_},
      plan_(captured, [this](const std::string& key) { return baker_.cache().find(key) != nullptr; }),
      baker_(with_, 0),
      binder_(with_),
      tuning_(with_) {
  binder_.needs().setAll(true);
  plan_.setFollowsBoxes(false);
}

void ProbeSet::updateShapes(const std::optional<ProbeEntries::Origins>& origins) {
  if (origins) {
    plan_.entries().follow(*origins);
    binder_.rearrange(*origins);
  } else if (const auto byName = plan_.entries().match()) {
    binder_.rearrange(*byName);
  }
  binder_.updateShapes();
}

void ProbeSet::updateCaptures(CaptureInputs inputs) {
  plan_.setWorld(std::move(inputs.world));
  plan_.wantSky(inputs.sky, inputs.skyColumns);
  baker_.setProps(std::move(inputs.props));
  plan_.sources().pictures.update(with_.content->scene);
  updateKeys();
  baker_.replan();
}

void ProbeSet::updateKeys() {
  plan_.updateKeys();
  binder_.wantSight();
}

void ProbeSet::give(std::size_t index, std::shared_ptr<const ProbeMaps> maps) {
  ProbeEntry& entry = plan_.entries()[index];
  entry.given = maps ? "given " + std::to_string(++given_) : std::string();
  entry.shown = entry.given;
  binder_.show(index, maps);
  if (maps) baker_.cache().add(entry.given, {}, std::move(maps));
  updateKeys();
  baker_.replan();
}

// If the scene's list has changed already, entries and plan follow with updateShapes().
void ProbeSet::setSeen(std::optional<std::vector<std::size_t>> objects) {
  if (!plan_.entries().setSeen(std::move(objects)) || !plan_.entries().matched()) return;
  updateKeys();
  baker_.replan();
}

void ProbeSet::setInteractive(bool interactive) {
  if (plan_.interactive() == interactive) return;
  plan_.setInteractive(interactive);
  with_.state->setDragging(interactive);
  binder_.holdSight(interactive);
  binder_.assign(true);
  baker_.replan();
}

void ProbeSet::setEnabled(bool enabled) {
  if (plan_.enabled() == enabled) return;
  plan_.setEnabled(enabled);
  binder_.assign();
  updateKeys();  // of a scene that came while no object had a probe
  baker_.replan();
}

void ProbeSet::setBakeTargets(const std::vector<std::string>& names, const std::vector<std::string>& cutShort) {
  plan_.setCutShort({cutShort.begin(), cutShort.end()});
  plan_.setTargets({names.begin(), names.end()});
  binder_.needs().setAll(!names.empty());
  updateKeys();
  baker_.replan();
}

std::vector<std::string> ProbeSet::bakeKeys(const std::string& probeName) const {
  const auto index = plan_.entries().find(probeName);
  if (!index || !plan_.entries().baked(*index) || plan_.bounces().input(*index).view.empty()) return {};
  std::vector<std::string> keys;
  for (int bounce = 1; bounce <= plan_.entries().probe(*index).bounces; ++bounce) {
    keys.push_back(plan_.bounces().key(*index, bounce));
  }
  return keys;
}

void ProbeSet::useBakedFiles(const std::string& folder) {
  plan_.sources().folder = folder.empty() ? BakeFolder() : BakeFolder(folder);
  updateKeys();
  baker_.replan();
}

std::vector<std::string> ProbeSet::sourceRemarks() const {
  std::vector<std::string> texts = plan_.sources().pictures.remarks();
  for (const std::string& damage : plan_.sources().folder.damaged())
    texts.push_back(damage + "; its probe is captured anew");
  return texts;
}

void ProbeSet::requestBake(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (const auto index = plan_.entries().find(name)) makeAnew(*index);
  }
  baker_.abort();
}

void ProbeSet::makeAnew(std::size_t index) {
  ProbeEntry& entry = plan_.entries()[index];
  if (plan_.entries().baked(index)) {
    for (int bounce = 1; bounce <= plan_.entries().probe(index).bounces; ++bounce) {
      baker_.cache().forget(plan_.bounces().key(index, bounce));
    }
    plan_.sources().folder.forget(entry.wanted);
    plan_.forget(index);
  }
  plan_.sources().pictures.forget(entry.name);
  entry.given.clear();
  entry.shown = "made anew";
  entry.faces = {};
  entry.again = true;
}

void ProbeSet::cancelWork() {
  levelsMade_ = 0;
  baker_.cancelWork();
  tuning_.cancelWork();
}

std::optional<std::size_t> ProbeSet::toMeasure() const {
  const bool never = with_.state->resources.foreign;  // their `auto` uses the measured table
  if (never || plan_.interactive() || tuning_.moving() || !plan_.enabled()) return std::nullopt;
  return binder_.toMeasure();
}

const ProbeMaps* ProbeSet::latticePending() const {
  for (std::size_t i = 0; i < binder_.size(); ++i) {
    const ProbeMaps* maps = binder_.drawn(i).maps.get();
    if (maps != nullptr && maps->lattice.pending()) return maps;
  }
  return nullptr;
}

void ProbeSet::step() {
  doOne();
  if (!workPending()) levelsMade_ = 0;
}

void ProbeSet::doOne() {
  if (plan_.memoryUnchecked() && !plan_.checkMemory(textureMemoryLimit(), binder_.sightBytes())) return cancelWork();
  // Shown meanwhile, and in no final picture.
  if (baker_.standIn()) return;
  if (plan_.coarsePending() && baker_.step()) return;
  // Before any capture, because shadows are part of it.
  if (sightPending()) {
    if (binder_.makeSight()) binder_.assign();
    return;
  }
  // First, because meanwhile the picture is not blurred enough.
  if (levelsPending()) return makeLevel();
  if (baker_.step()) return;
  if (const auto index = toMeasure()) {
    binder_.measure(*index);
  } else if (with_.state->tuning != nullptr && tuning_.pending()) {
    tuning_.prepareOne();
  } else if (const ProbeMaps* maps = latticePending()) {
    constexpr int kTurnMilliseconds = 5;  // so that a window stays responsive
    maps->lattice.take(kTurnMilliseconds);
  }
}

// Realtime probes of several bounces may have sampled other levels while these were missing, during a drag. They
// converge again after as many rounds as they have bounces.
void ProbeSet::makeLevel() {
  const bool seen = binder_.needs().makeOne();
  ++levelsMade_;
  bool again = false;
  for (std::size_t i = 0; seen && i < plan_.entries().size(); ++i) {
    const Probe& probe = plan_.entries().probe(i);
    if (probe.mode != ProbeMode::Realtime || probe.bounces < 2 || plan_.entries()[i].passes >= probe.bounces) continue;
    plan_.entries()[i].passes = probe.bounces;
    again = true;
  }
  if (again) baker_.replan();
}

void ProbeSet::setCoarseFirst(bool coarse) {
  plan_.setCoarseFirst(coarse);
  if (plan_.entries().matched()) baker_.replan();
}

void ProbeSet::setSharp(std::map<std::string, int> faceSizes) {
  if (faceSizes == plan_.sharp()) return;
  plan_.setSharp(std::move(faceSizes));
  if (plan_.entries().matched()) baker_.replan();
}

WorkNow ProbeSet::workNow() const {
  WorkNow now;
  now.what = WorkNow::What::Rest;
  for (std::size_t i = 0; i < plan_.entries().size(); ++i) {
    if (!plan_.entries()[i].needed()) continue;
    ++now.used;
    now.missing += plan_.stale(i) ? 1 : 0;
  }
  if (const auto& job = plan_.current()) {
    now.what = job->kind == JobKind::Coarse ? WorkNow::What::Coarse : WorkNow::What::Capture;
    now.probe = job->name;
    const auto index = plan_.entries().find(job->name);
    if (job->kind == JobKind::Bounce && index) {
      now.bounce = job->bounce;
      now.bounces = plan_.entries().probe(*index).bounces;
    }
  } else if (sightPending()) {
    now.what = WorkNow::What::Shadows;
  }
  return now;
}

double ProbeSet::progress() const {
  if (!workPending()) return 1.0;
  constexpr double kMost = 0.99;  // programs and measurements are not counted
  const double levels = plan_.interactive() ? 0.0 : binder_.needs().left();
  const double done = baker_.unitsDone() + levelsMade_, left = baker_.unitsLeft() + levels;
  return done + left > 0.0 ? std::min(done / (done + left), kMost) : kMost;
}

std::shared_ptr<const ProbeMaps> ProbeSet::maps(const std::string& probeName) const {
  const auto index = plan_.entries().find(probeName);
  return index ? maps(*index) : nullptr;
}

std::optional<ProbeDiffuse> ProbeSet::diffuseLight(std::size_t index) const {
  if (index >= binder_.size() || !maps(index)) return std::nullopt;
  const DrawnProbe& drawn = binder_.drawn(index);
  ProbeDiffuse diffuse;
  diffuse.coefficients = drawn.maps->irradiance;
  for (std::size_t i = 0; i < diffuse.coefficients.size() && drawn.open; ++i) {
    diffuse.coefficients[i] += drawn.openSky[i];
  }
  diffuse.sight = drawn.sight;
  if (!drawn.latticeBefore || drawn.latticeBefore->empty() || !with_.content->lamps) return diffuse;
  diffuse.lattice = drawn.latticeBefore;
  for (const std::size_t lamp : drawn.lamps) {
    diffuse.lamps.push_back(with_.content->lamps->lamps[lamp]);
    if (drawn.sight) diffuse.lampChannels.push_back(drawn.sight->channelOfLamp(lamp));
  }
  return diffuse;
}

std::size_t ProbeSet::memoryBytes() const {
  std::size_t bytes = baker_.cache().bytes();
  for (std::size_t i = 0; i < binder_.size(); ++i) {
    const bool kept = plan_.entries().probe(i).mode != ProbeMode::Realtime && !plan_.showsSharp(i);
    if (maps(i) && !kept) bytes += maps(i)->bytes();
  }
  return bytes;
}

void ProbeSet::release() {
  baker_.release();
  binder_.release();
  for (std::size_t i = 0; i < plan_.entries().size(); ++i) {
    ProbeEntry& entry = plan_.entries()[i];
    entry.shown.clear();
    entry.given.clear();
    entry.faces = {};
  }
  plan_.skyShows({});
}

}  // namespace boxprobe
