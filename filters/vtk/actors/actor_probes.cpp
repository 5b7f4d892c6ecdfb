#include "filters/vtk/actors/actor_probes.h"

#include <vtkOpenGLRenderWindow.h>

#include <algorithm>
#include <optional>

#include "filters/core/base/errors.h"
#include "filters/vtk/actors/actor_parts.h"
#include "filters/vtk/maps/cube_transfer.h"

namespace boxprobe {

struct ActorProbes::Parts : ActorParts {
  using ActorParts::ActorParts;
};

namespace {

constexpr const char* kNoRenderer = "probes need a renderer; they were made with a null one";

}  // namespace

ActorProbes::ActorProbes(vtkRenderer* renderer) : parts_(std::make_unique<Parts>(renderer)) {
  if (renderer == nullptr) parts_->state->counts.fail(kNoRenderer);
}

ActorProbes::~ActorProbes() = default;

namespace {

void check(const Scene& scene) {
  for (const Probe& probe : scene.probes) {
    if (probe.mode != ProbeMode::Baked) {
      throw InputError("probes." + probe.name + ".mode: only \"baked\" probes light other programs' actors");
    }
  }
  validate(scene);
}

}  // namespace

std::size_t ActorProbes::addProbe(const Probe& probe) {
  const std::size_t index = probes().size();
  insertProbe(index, probe);
  return index;
}

void ActorProbes::insertProbe(std::size_t index, const Probe& probe) {
  const auto at = static_cast<std::ptrdiff_t>(std::min(index, probes().size()));
  Scene next = parts_->content.scene;
  next.probes.insert(next.probes.begin() + at, probe);
  check(next);
  parts_->content.scene = std::move(next);
  ProbeEntries::Origins origins;
  for (std::size_t i = 0; i + 1 < probes().size(); ++i) origins.emplace_back(i);
  origins.insert(origins.begin() + at, std::nullopt);
  parts_->probesChanged(origins);
}

void ActorProbes::removeProbe(std::size_t index) {
  std::vector<Probe>& probes = parts_->content.scene.probes;
  if (index >= probes.size()) throw InputError("removeProbe: there is no probe " + std::to_string(index));
  ProbeEntries::Origins origins;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (i != index) origins.emplace_back(i);
  }
  probes.erase(probes.begin() + static_cast<std::ptrdiff_t>(index));
  parts_->probesChanged(origins);
}

void ActorProbes::setProbe(std::size_t index, const Probe& probe) {
  Scene next = parts_->content.scene;
  if (index >= next.probes.size()) {
    throw InputError("setProbe: there is no probe " + std::to_string(index) + "; there are " +
                     std::to_string(next.probes.size()));
  }
  next.probes[index] = probe;
  check(next);
  parts_->content.scene = std::move(next);
  parts_->probesChanged();
}

const std::vector<Probe>& ActorProbes::probes() const {
  return parts_->content.scene.probes;
}

bool ActorProbes::addActor(vtkActor* actor, bool seenByProbes) {
  if (actor == nullptr) {
    parts_->state->counts.fail("addActor: the actor is null");
    return false;
  }
  std::vector<DrawnObject>& objects = parts_->content.objects;
  const std::size_t index = parts_->indexOf(actor);
  if (index < objects.size()) {
    objects[index].settings.seenByProbes = seenByProbes;
    return true;
  }
  if (vtkProbePass::HasOther(actor, nullptr)) {
    parts_->state->counts.fail("another object lights this actor by its probes already; take the actor off that first");
    return false;
  }
  DrawnObject object;
  object.actor = actor;
  object.pass = vtkSmartPointer<vtkProbePass>::New();
  object.pass->SetDrawState(parts_->state);
  object.pass->Attach(actor, actor);
  object.settings.seenByProbes = seenByProbes;
  objects.push_back(std::move(object));
  return true;
}

void ActorProbes::removeActor(vtkActor* actor) {
  std::vector<DrawnObject>& objects = parts_->content.objects;
  const std::size_t index = parts_->indexOf(actor);
  if (index >= objects.size()) return;
  objects[index].pass->Detach();
  parts_->framesWithout.erase(actor);
  objects.erase(objects.begin() + static_cast<std::ptrdiff_t>(index));
}

void ActorProbes::removeAllActors() {
  while (!parts_->content.objects.empty()) removeActor(parts_->content.objects.back().actor);
}

void ActorProbes::setSky(const Sky& sky, double rotationDegrees) {
  Scene next = parts_->content.scene;
  next.sky = sky;
  next.skyRotationDegrees = rotationDegrees;
  check(next);
  std::swap(parts_->content.scene, next);
  try {
    parts_->content.rebuildSky(true);
  } catch (const Error&) {
    std::swap(parts_->content.scene, next);
    throw;
  }
  parts_->content.sky->SetSkyFromWorld(glm::dmat3(1.0));
  parts_->lightSky->SetSky(sky, rotationDegrees, parts_->content.skyImage);
  parts_->lightSky->SetSkyFromWorld(glm::dmat3(1.0));
  parts_->skyGiven = true;
  ++parts_->skies;
}

void ActorProbes::clearSky() {
  if (!parts_->skyGiven) return;
  parts_->skyGiven = false;
  parts_->surroundings = {};
  parts_->refreshSky();
}

void ActorProbes::setExposure(double exposure) {
  parts_->state->setExposure(static_cast<float>(exposure));
}

void ActorProbes::setTone(Tone tone) {
  parts_->state->resources.tone = tone;
}

void ActorProbes::setEmission(bool shown) {
  parts_->state->resources.emission = shown;
  for (DrawnObject& object : parts_->content.objects) object.pass->Rebuild();
}

void ActorProbes::setEnergy(Energy energy) {
  parts_->state->resources.lightForm = energy == Energy::Multiple ? LightForm::Multiple : LightForm::Single;
  for (DrawnObject& object : parts_->content.objects) object.pass->Rebuild();
}

bool ActorProbes::capture() {
  clearError();
  if (parts_->begin(true)) {
    while (parts_->step()) {
    }
  }
  return error().empty();
}

bool ActorProbes::update() {
  if (!parts_->working) {
    if (!parts_->anyStale()) return true;
    clearError();
    if (!parts_->begin(false)) return error().empty();
  }
  while (parts_->step()) {
  }
  return error().empty();
}

bool ActorProbes::updateStep() {
  if (!parts_->working && !parts_->begin(false)) return false;
  return parts_->step();
}

bool ActorProbes::stale() {
  return parts_->anyStale();
}

void ActorProbes::setProgress(std::function<void(double)> progress) {
  parts_->progress = std::move(progress);
}

void ActorProbes::setFrameCalls(std::function<void()> before, std::function<void()> after) {
  parts_->beforeFrame = std::move(before);
  parts_->afterFrame = std::move(after);
}

void ActorProbes::setMaps(std::size_t index, const BakedMaps& maps) {
  parts_->ready();
  parts_->window->MakeCurrent();
  setMaps(index, upload(maps));
}

void ActorProbes::setMaps(std::size_t index, std::shared_ptr<const ProbeMaps> maps) {
  if (index >= probes().size()) throw InputError("there is no probe " + std::to_string(index));
  if (maps) {
    // The materials of these actors are unknown. The maps may belong to another window, whose context filters them.
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(parts_->renderer->GetRenderWindow());
    const bool current = window != nullptr && window->IsCurrent();
    maps->need(kAllLevels);
    if (current) window->MakeCurrent();
  }
  parts_->dropWork();
  parts_->probes.give(index, std::move(maps));
  parts_->probesChanged();
}

std::shared_ptr<const ProbeMaps> ActorProbes::maps(std::size_t index) const {
  return index < probes().size() ? parts_->probes.maps(index) : nullptr;
}

void ActorProbes::setRefinement(const RefineSettings& settings) {
  if (settings == parts_->refineTo) return;
  parts_->refineTo = settings;
  parts_->stopRefining();
  if (settings.rays <= 0) parts_->pictureShown.clear();
}

bool ActorProbes::refineStep() {
  return parts_->refineStep();
}

std::uint64_t ActorProbes::pictures() const {
  return parts_->pictures;
}

bool ActorProbes::refining() const {
  return parts_->refining;
}

RefineState ActorProbes::refineState() const {
  if (!parts_->refining) return {};
  const Refinement& stages = parts_->frames.refinement();
  return {stages.raysDone(), parts_->frames.count().more(), stages.left()};
}

double ActorProbes::refineProgress() const {
  if (!parts_->refining) return 0.0;
  const FrameCount count = parts_->frames.count();
  return count.more() ? static_cast<double>(count.averaged) / count.wanted : parts_->working ? 0.0 : 1.0;
}

std::string ActorProbes::refusedRefinement() const {
  return parts_->refusedRefinement();
}

const std::string& ActorProbes::error() const {
  return parts_->state->counts.error;
}

void ActorProbes::clearError() {
  parts_->state->counts.error.clear();
  if (parts_->nothing) parts_->state->counts.fail(kNoRenderer);
}

const std::vector<std::string>& ActorProbes::remarks() const {
  return parts_->remarks;
}

void ActorProbes::releaseGraphics() {
  parts_->release();
}

}  // namespace boxprobe
