#include "filters/vtk/probes/probe_set.h"

#include <algorithm>

#include "filters/vtk/gl/texture_memory.h"

namespace boxprobe {

ProbeSet::ProbeSet(vtkOpenGLRenderWindow* window, const std::shared_ptr<DrawState>& state, CubeCapture* capture,
                   SceneContent* content, Times* times)
    : with_{content, state,  capture, &cache_, &sources_, &entries_,
            &keys_,  &plan_, &shown_, &needs_, &light_,   &programs_},
      sources_{[this](const std::string& key) { return cache_.find(key) != nullptr; }, {}, {}, {}},
      entries_(&content->scene),
      keys_(&entries_, &sources_),
      plan_(&entries_, &keys_, &sources_),
      shown_(&content->scene, state),
      needs_(content, &shown_, state.get()),
      light_(content, state, &shown_),
      errors_(&entries_, &shown_, state),
      programs_(with_),
      baker_(with_, window, times) {}

void ProbeSet::updateShapes() {
  if (const auto origins = entries_.match()) shown_.rearrange(*origins);
  shown_.updateShapes();
  light_.updateShadowLights();
  light_.updateLamps();
  light_.updateOpenings();  // the caller assigns
}

void ProbeSet::updateKeys() {
  keys_.update(plan_.targets());
}

void ProbeSet::updateCaptures() {
  keys_.setWorld(inputs_.world(*with_.content, entries_.places()));
  sources_.pictures.update(with_.content->scene);
  updateKeys();
  sources_.skyLevels = with_.content->skyImage ? skyLevelsFile(with_.content->skyImageFile()) : std::string();
  plan_.wantSky(keys_.world().sky, with_.content->skyImage ? with_.content->skyImage->width : 0);
  baker_.replan();
}

// Where the scene's list has changed already, its entries follow with updateShapes(), and so does the plan.
void ProbeSet::setSeen(std::optional<std::vector<std::size_t>> objects) {
  if (!entries_.setSeen(std::move(objects)) || !entries_.matched()) return;
  updateKeys();
  baker_.replan();
}

void ProbeSet::setInteractive(bool interactive) {
  if (plan_.interactive() == interactive) return;
  plan_.setInteractive(interactive);
  with_.state->setDragging(interactive);
  light_.holdSight(interactive);
  programs_.assignAll();
  baker_.replan();
}

void ProbeSet::setEnabled(bool enabled) {
  if (plan_.enabled() == enabled) return;
  plan_.setEnabled(enabled);
  assignToObjects();
  baker_.replan();
}

void ProbeSet::setBakeTargets(const std::vector<std::string>& names) {
  plan_.setTargets({names.begin(), names.end()});
  needs_.setAll(!names.empty());
  updateKeys();
  baker_.replan();
}

std::vector<std::string> ProbeSet::bakeKeys(const std::string& probeName) const {
  const auto index = entries_.find(probeName);
  if (!index || !entries_.baked(*index) || keys_.bounces().input(*index).view.empty()) return {};
  std::vector<std::string> keys;
  for (int bounce = 1; bounce <= entries_.probe(*index).bounces; ++bounce) {
    keys.push_back(keys_.bounces().key(*index, bounce));
  }
  return keys;
}

void ProbeSet::useBakedFiles(const std::string& folder) {
  sources_.folder = folder.empty() ? BakeFolder() : BakeFolder(folder);
  updateKeys();
  baker_.replan();
}

std::vector<std::string> ProbeSet::sourceRemarks() const {
  std::vector<std::string> texts = sources_.pictures.remarks();
  for (const std::string& damage : sources_.folder.damaged()) texts.push_back(damage + "; its probe is captured anew");
  return texts;
}

void ProbeSet::requestBake(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (const auto index = entries_.find(name)) makeAnew(*index);
  }
  baker_.abort();
  updateCaptures();
}

void ProbeSet::makeAnew(std::size_t index) {
  ProbeEntry& entry = entries_[index];
  if (entries_.baked(index)) {
    for (int bounce = 1; bounce <= entries_.probe(index).bounces; ++bounce) {
      cache_.forget(keys_.bounces().key(index, bounce));
    }
    sources_.folder.forget(entry.wanted);
    keys_.forget(index);
  }
  sources_.pictures.forget(entry.name);
  entry.shown = "made anew";
  entry.faces = {};
  entry.again = true;
}

void ProbeSet::giveUp() {
  levelsMade_ = 0;
  baker_.giveUp();
  programs_.giveUp();
}

std::optional<std::size_t> ProbeSet::toMeasure() const {
  if (plan_.interactive() || programs_.moving() || !plan_.enabled()) return std::nullopt;
  return errors_.next();
}

void ProbeSet::step() {
  doOne();
  if (!workPending()) levelsMade_ = 0;
}

void ProbeSet::doOne() {
  if (plan_.memoryUnchecked() && !plan_.checkMemory(textureMemoryLimit())) return giveUp();
  // Before anything is captured, which their shadows are part of.
  if (sightPending()) {
    if (light_.makeSight()) assignToObjects();
    return;
  }
  // First, because what is drawn meanwhile shows too little of a blur.
  if (levelsPending()) return makeLevel();
  if (baker_.step()) return;
  if (const auto index = toMeasure()) {
    errors_.measure(*index);
    assignToObjects();
  } else if (programs_.pending()) {
    programs_.prepareOne();
  }
}

// Realtime probes of several bounces saw the other levels, if any, while they were missing: in a drag, that is. They
// come to rest again by as many rounds as they have bounces.
void ProbeSet::makeLevel() {
  const bool seen = needs_.makeOne();
  ++levelsMade_;
  bool again = false;
  for (std::size_t i = 0; seen && i < entries_.size(); ++i) {
    const Probe& probe = entries_.probe(i);
    if (probe.mode != ProbeMode::Realtime || probe.bounces < 2 || entries_[i].passes >= probe.bounces) continue;
    entries_[i].passes = probe.bounces;
    again = true;
  }
  if (again) baker_.replan();
}

double ProbeSet::progress() const {
  if (!workPending()) return 1.0;
  constexpr double kMost = 0.99;  // programs and measurements are not counted
  const double levels = plan_.interactive() ? 0.0 : needs_.left();
  const double done = baker_.unitsDone() + levelsMade_, left = baker_.unitsLeft() + levels;
  return done + left > 0.0 ? std::min(done / (done + left), kMost) : kMost;
}

std::shared_ptr<const ProbeMaps> ProbeSet::maps(const std::string& probeName) const {
  const auto index = entries_.find(probeName);
  return index ? maps(*index) : nullptr;
}

std::optional<ShCoefficients> ProbeSet::diffuseLight(const std::string& probeName) const {
  const auto index = entries_.find(probeName);
  if (!index || !maps(*index)) return std::nullopt;
  const DrawnProbe& drawn = shown_.drawn(*index);
  ShCoefficients sum = drawn.maps->irradiance;
  if (!drawn.open) return sum;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += drawn.openSky[i];
  return sum;
}

std::size_t ProbeSet::memoryBytes() const {
  std::size_t bytes = cache_.bytes();
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (maps(i) && entries_.probe(i).mode == ProbeMode::Realtime) bytes += maps(i)->bytes();
  }
  return bytes;
}

void ProbeSet::release() {
  baker_.release();
  cache_.clear();
  shown_.release();
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    entries_[i].shown.clear();
    entries_[i].faces = {};
  }
  plan_.skyShows({});
}

}  // namespace boxprobe
