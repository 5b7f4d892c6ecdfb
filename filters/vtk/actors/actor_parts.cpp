#include "filters/vtk/actors/actor_parts.h"

#include <vtkLightCollection.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>

#include "filters/core/base/at_end.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/draw/static_textures.h"
#include "filters/vtk/probes/probe_assignment.h"

namespace boxprobe {

namespace {

constexpr int kSkyFaceSize = 256;

ActorState stateOf(vtkActor* actor) {
  ActorState state;
  if (const double* b = actor->GetBounds()) std::copy(b, b + 6, state.bounds.begin());
  vtkProperty* property = actor->GetProperty();
  const bool textured = property->GetTexture("materialTex") != nullptr;
  state.roughnessMin = textured ? 0.0 : property->GetRoughness();
  state.roughnessMax = property->GetRoughness();
  if (property->GetCoatStrength() > 0.0) {
    state.roughnessMin = std::min(state.roughnessMin, property->GetCoatRoughness());
    state.roughnessMax = std::max(state.roughnessMax, property->GetCoatRoughness());
  }
  state.allMetal = property->GetMetallic() == 1.0 && !textured;
  return state;
}

/// A light that captures see where the renderer's stands: those that follow its camera must not follow the captures'.
vtkSmartPointer<vtkLight> standing(vtkLight* light) {
  auto copy = vtkSmartPointer<vtkLight>::New();
  copy->DeepCopy(light);
  copy->SetLightTypeToSceneLight();
  copy->SetTransformMatrix(nullptr);
  double at[3], towards[3];
  light->GetTransformedPosition(at);
  light->GetTransformedFocalPoint(towards);
  copy->SetPosition(at);
  copy->SetFocalPoint(towards);
  return copy;
}

}  // namespace

ActorParts::ActorParts(vtkRenderer* shown)
    : renderer(shown),
      draws(std::make_shared<ActorDraws>()),
      state(draws, &draws->state),
      shownProbes(&content.scene, state),
      light(&content, state, &shownProbes) {
  content.scene.sky = SkyColor{};
  content.sky->SetDrawState(state);
  state->shown = renderer;
  observer->SetClientData(this);
  observer->SetCallback([](vtkObject*, unsigned long event, void* client, void*) {
    auto* parts = static_cast<ActorParts*>(client);
    event == vtkCommand::StartEvent ? parts->beginFrame() : parts->endFrame();
  });
  renderer->AddObserver(vtkCommand::StartEvent, observer);
  renderer->AddObserver(vtkCommand::EndEvent, observer);
}

ActorParts::~ActorParts() {
  renderer->RemoveObserver(observer);
  for (LitActor& lit : actors) lit.pass->Detach();
  release();
}

ActorParts::Graphics& ActorParts::ready() {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr) {
    throw InputError("probes need a renderer that belongs to a vtkOpenGLRenderWindow; call AddRenderer() first");
  }
  if (graphics && graphics->window != window) release();
  if (!graphics) graphics = std::make_unique<Graphics>(window, state);
  makeStaticTextures(window, state->resources, state->counts);
  return *graphics;
}

void ActorParts::beginFrame() {
  draws->renderer = renderer;
  try {
    ready();
  } catch (const Error& failure) {
    state->counts.fail(failure.what());
    draws->renderer = nullptr;  // and so VTK's own programs, until the next frame asks for ours again
    for (LitActor& lit : actors) lit.pass->Rebuild();
    return;
  }
  state->setExposure(static_cast<float>(exposure));
  vtkOpenGLState* gl = graphics->window->GetState();
  seamlessBefore = gl->GetEnumState(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  gl->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  assign();
}

void ActorParts::endFrame() {
  draws->bound.clear();
  if (!seamlessBefore && draws->renderer != nullptr && graphics)
    graphics->window->GetState()->vtkglDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void ActorParts::assign() {
  const auto drawn = shownProbes.all();
  for (std::size_t i = 0; i < actors.size(); ++i) {
    LitActor& lit = actors[i];
    const ActorState now = stateOf(lit.actor);
    if (lit.assigned && now == lit.state) continue;
    lit.state = now;
    lit.assigned = true;
    DrawnObject& object = content.objects[i];
    object.allMetal = now.allMetal;
    object.roughnessMin = now.roughnessMin;
    object.roughnessMax = now.roughnessMax;
    lit.pass->SetBinding(assignProbes(object, content.scene, drawn, places.meeting(worldBounds(object)), true, false));
  }
}

void ActorParts::probesChanged() {
  shownProbes.updateShapes();
  light.updateShadowLights();
  light.updateOpenings();
  for (std::size_t i = 0; i < shownProbes.size(); ++i) {
    // Means of frames and smoothed samples take passes over the picture, which is not ours.
    shownProbes.drawn(i).geometry.animated = shownProbes.drawn(i).geometry.blurred = false;
  }
  places = ProbeIndex(content.scene.probes);
  for (LitActor& lit : actors) lit.assigned = false;
}

void ActorParts::show(std::size_t index, std::shared_ptr<const ProbeMaps> maps) {
  shownProbes.show(index, std::move(maps));
  probesChanged();
}

FaceSource ActorParts::everythingSeen(bool sky) const {
  FaceSource source;
  for (const DrawnObject& object : content.objects) {
    if (object.settings.seenByProbes && object.actor->GetVisibility() != 0) source.props.push_back(object.actor);
  }
  if (sky) source.props.push_back(content.sky);
  for (const auto& one : captureLights) source.lights.push_back(one);
  return source;
}

void ActorParts::finish(Graphics& with, BakeItem item) {
  with.runner.start(std::move(item));
  while (with.runner.pending()) with.runner.step();
  draws->bound.clear();
}

void ActorParts::captureSky(Graphics& with) {
  if (!skyStale) return;
  BakeItem item;
  item.sky = true;
  item.faceSize = kSkyFaceSize;
  item.settings.samplesPerTexelSide = content.skyImage ? 4 : 1;
  item.face = [this](int) { return FaceSource{nullptr, {content.sky}, {captureLights.front()}}; };
  item.publish = [this](std::shared_ptr<const ProbeMaps> maps) { state->resources.sky = std::move(maps); };
  finish(with, std::move(item));
  skyStale = false;
}

// A bounce of all probes before the next bounce of any: each sees the others, and itself, as of the bounce before.
void ActorParts::captureProbes(Graphics& with) {
  const std::vector<Probe>& probes = content.scene.probes;
  int bounces = 0;
  for (const Probe& probe : probes) bounces = std::max(bounces, probe.bounces);
  for (int bounce = 1; bounce <= bounces; ++bounce) {
    std::vector<std::shared_ptr<const ProbeMaps>> made(probes.size());
    for (std::size_t i = 0; i < probes.size(); ++i) {
      if (bounce > probes[i].bounces) continue;
      const bool sky = std::holds_alternative<ClearToSky>(probes[i].clear);
      BakeItem item;
      item.settings = captureSettings(probes[i]);
      item.prefilter = prefilterSettings(probes[i]);
      item.faceSize = probes[i].faceSize;
      item.bounce = bounce;
      item.reflectNothing = bounce == 1;
      if (std::holds_alternative<ClearToOpen>(probes[i].clear)) item.drawing = shownProbes.withoutSky({});
      item.face = [this, sky](int) { return everythingSeen(sky); };
      item.publish = [&made, i](std::shared_ptr<const ProbeMaps> maps) { made[i] = std::move(maps); };
      finish(with, std::move(item));
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
      if (made[i]) shownProbes.show(i, made[i]);
    }
    probesChanged();
    assign();
  }
}

void ActorParts::release() {
  draws->bound.clear();
  shownProbes.release();
  skyStale = true;
  if (!graphics) return;
  graphics->window->MakeCurrent();
  graphics->runner.release();
  graphics->capture.release();
  content.sky->ReleaseGraphicsResources(graphics->window);
  releaseStaticTextures(state->resources);
  graphics.reset();
}

void ActorParts::capture() {
  state->counts.error.clear();
  try {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    if (window != nullptr) {
      window->Initialize();
      window->MakeCurrent();
    }
    Graphics& with = ready();
    // Lights that follow the camera stand where it is now.
    renderer->UpdateLightsGeometryToFollowCamera();
    captureLights.clear();
    vtkLightCollection* lights = renderer->GetLights();
    vtkCollectionSimpleIterator it;
    lights->InitTraversal(it);
    while (vtkLight* lamp = lights->GetNextLight(it)) captureLights.push_back(standing(lamp));
    if (captureLights.empty()) {  // VTK shades nothing physically without one
      captureLights.push_back(vtkSmartPointer<vtkLight>::New());
      captureLights.back()->SetLightTypeToHeadlight();
      captureLights.back()->SetIntensity(0.0);
    }
    const AtEnd shown([this] { draws->renderer = renderer; });
    draws->renderer = with.capture.renderer();
    captureSky(with);
    assign();
    captureProbes(with);
  } catch (const WorkError& failure) {
    state->counts.fail(failure.what());
    if (graphics) graphics->runner.abort();
  }
}

}  // namespace boxprobe
