#include "filters/vtk/actors/actor_probes.h"

#include <vtkOpenGLRenderWindow.h>

#include "filters/core/base/errors.h"
#include "filters/vtk/actors/actor_parts.h"
#include "filters/vtk/maps/cube_transfer.h"

namespace boxprobe {

struct ActorProbes::Parts : ActorParts {
  using ActorParts::ActorParts;
};

ActorProbes::ActorProbes(vtkRenderer* renderer) : parts_(std::make_unique<Parts>(renderer)) {}

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
  Scene next = parts_->content.scene;
  next.probes.push_back(probe);
  check(next);
  parts_->content.scene = std::move(next);
  ProbeEntries::Origins origins;
  for (std::size_t i = 0; i < parts_->shownProbes.size(); ++i) origins.emplace_back(i);
  origins.emplace_back();
  parts_->shownProbes.rearrange(origins);
  parts_->probesChanged();
  return origins.size() - 1;
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

void ActorProbes::addActor(vtkActor* actor, bool seenByProbes) {
  const auto at = parts_->find(actor);
  if (at != parts_->actors.end()) {
    parts_->content.objects[static_cast<std::size_t>(at - parts_->actors.begin())].settings.seenByProbes = seenByProbes;
    return;
  }
  LitActor lit;
  lit.actor = actor;
  lit.pass = vtkSmartPointer<vtkActorProbesPass>::New();
  lit.pass->SetDraws(parts_->draws);
  lit.pass->Attach(actor);
  parts_->actors.push_back(std::move(lit));
  DrawnObject object;
  object.actor = actor;
  object.settings.seenByProbes = seenByProbes;
  parts_->content.objects.push_back(std::move(object));
}

void ActorProbes::removeActor(vtkActor* actor) {
  const auto at = parts_->find(actor);
  if (at == parts_->actors.end()) return;
  at->pass->Detach();
  parts_->content.objects.erase(parts_->content.objects.begin() + (at - parts_->actors.begin()));
  parts_->actors.erase(at);
}

void ActorProbes::removeAllActors() {
  while (!parts_->actors.empty()) removeActor(parts_->actors.back().actor);
}

void ActorProbes::setSky(const Sky& sky, double rotationDegrees) {
  Scene next = parts_->content.scene;
  next.sky = sky;
  next.skyRotationDegrees = rotationDegrees;
  check(next);
  std::swap(parts_->content.scene, next);
  try {
    parts_->content.rebuildSky();
  } catch (const Error&) {
    std::swap(parts_->content.scene, next);
    throw;
  }
  parts_->skyStale = true;
}

void ActorProbes::setExposure(double exposure) {
  parts_->exposure = exposure;
}

void ActorProbes::setEmission(bool shown) {
  parts_->draws->emission = shown;
  for (LitActor& lit : parts_->actors) lit.pass->Rebuild();
}

void ActorProbes::setEnergy(Energy energy) {
  parts_->state->resources.lightForm = energy == Energy::Multiple ? LightForm::Multiple : LightForm::Single;
  for (LitActor& lit : parts_->actors) lit.pass->Rebuild();
}

bool ActorProbes::capture() {
  parts_->capture();
  return error().empty();
}

void ActorProbes::setMaps(std::size_t index, const BakedMaps& maps) {
  parts_->ready().window->MakeCurrent();
  setMaps(index, upload(maps));
}

void ActorProbes::setMaps(std::size_t index, std::shared_ptr<const ProbeMaps> maps) {
  if (index >= parts_->shownProbes.size()) throw InputError("there is no probe " + std::to_string(index));
  if (maps) {
    // Of these actors' materials nobody knows. The maps may be another window's, whose context filters them.
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(parts_->renderer->GetRenderWindow());
    const bool current = window != nullptr && window->IsCurrent();
    maps->need(kAllLevels);
    if (current) window->MakeCurrent();
  }
  parts_->show(index, std::move(maps));
}

std::shared_ptr<const ProbeMaps> ActorProbes::maps(std::size_t index) const {
  return index < parts_->shownProbes.size() ? parts_->shownProbes.drawn(index).maps : nullptr;
}

const std::string& ActorProbes::error() const {
  return parts_->state->counts.error;
}

void ActorProbes::clearError() {
  parts_->state->counts.error.clear();
}

void ActorProbes::releaseGraphics() {
  parts_->release();
}

}  // namespace boxprobe
