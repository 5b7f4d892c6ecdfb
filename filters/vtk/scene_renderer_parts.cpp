#include "filters/vtk/scene_renderer_parts.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <algorithm>
#include <chrono>

#include "filters/core/base/errors.h"
#include "filters/core/base/scope_exit.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/vtk/draw/program_tuning.h"
#include "filters/vtk/draw/static_textures.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

std::string lampsKey(const SceneLamps& lamps) {
  ContentHash hash;
  hash.add("lamps as shapes, from the capture origin, in place of light sources");
  for (const SceneLamp& lamp : lamps.lamps) {
    hash.add(static_cast<double>(lamp.corners.size())).add(lamp.bothSides ? 1 : 0).addVector(lamp.radiance);
    hash.add(lamp.light ? 1 : 0);
    for (const glm::dvec3& corner : lamp.corners) hash.addVector(corner);
  }
  return hash.text();
}

// Samples per texel of a planar mirror's picture that is drawn at screen resolution.
constexpr int kMirrorSamples = 4;

}  // namespace

SceneParts::SceneParts(vtkOpenGLRenderWindow* shownIn)
    : window(shownIn),
      state(std::make_shared<DrawState>()),
      probes(&content, state),
      inspector(window, state, &content),
      frames(window, renderer, state, &content),
      mirrors(window, state, &content),
      sphere(window, renderer, state),
      outline(window, renderer),
      shadows(window, state, &content),
      suns(window, state, &content) {
  state->shown = renderer;
  probes.baker().setWindow(window);
  content.sky->SetDrawState(state);
  ground->SetCounters(&state->counts.counters);
  renderer->AutomaticLightCreationOff();
  renderer->SetLightFollowCamera(false);
  renderer->SetBackground(0.0, 0.0, 0.0);
  frameObserver->SetClientData(this);
  frameObserver->SetCallback([](vtkObject*, unsigned long event, void* client, void*) {
    auto* parts = static_cast<SceneParts*>(client);
    if (event == vtkCommand::StartEvent) {
      parts->beginFrame();
    } else {
      parts->endFrame();
    }
  });
  renderer->AddObserver(vtkCommand::StartEvent, frameObserver);
  renderer->AddObserver(vtkCommand::EndEvent, frameObserver);
  window->AddRenderer(renderer);
}

SceneParts::~SceneParts() {
  releaseGraphics();
  renderer->RemoveObserver(frameObserver);
  window->RemoveRenderer(renderer);
}

void SceneParts::makeCurrent() {
  if (state->resources.brdfTable != 0) window->MakeCurrent();
}

void SceneParts::prepareDraws() {
  makeStaticTextures(window, state->resources, state->counts);
  view.upload(window, state->resources);
  suns.update();
  shadows.update();
  content.resetClippingRange(renderer);
}

void SceneParts::drawMirrors(double aspect, int width, int height, int samples) {
  try {
    mirrors.draw(renderer->GetActiveCamera(), aspect, width, height, samples);
  } catch (const Error& failure) {
    mirrors.hide();
    state->counts.fail(failure.what());
  }
}

void SceneParts::beginFrame() {
  prepareDraws();
  if (content.scene.background == Background::Blurred && state->resources.sky) {
    state->resources.sky->need(LevelMask{1} << vtkSkyProp::BlurredLevel(*state->resources.sky));
  }
  try {
    ground->SetShadow(view.any() ? nullptr : groundWork.known());
    takeOpenness(std::chrono::milliseconds(0));
  } catch (const Error& failure) {
    state->counts.fail(failure.what());
  }
  window->GetState()->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  state->setExposure(static_cast<float>(content.scene.exposure));
  Counters& counters = state->counts.counters;
  state->counts.beginFrame();
  counters.drawsByProbeCount = {};
  counters.drawsWithOpenSky = counters.drawsWithCoverage = 0;
  counters.glassDraws = counters.glassPasses = 0;
  frames.beginFrame(view.any(), probes.workPending());
  if (sphere.shown()) {
    const auto index = findProbe(content.scene, sphere.settings().probe);
    const auto maps = probes.maps(sphere.settings().probe);
    sphere.follow(index ? &content.scene.probes[*index] : nullptr, maps);
    probes.binder().needs().also(maps, maps ? sphere.sampled(*maps) : 0);
  } else {
    probes.binder().needs().also(nullptr, 0);
  }
  const int* size = renderer->GetSize();
  drawMirrors(renderer->GetTiledAspectRatio(), size[0], size[1], kMirrorSamples);
}

void SceneParts::endFrame() {
  ++state->counts.counters.renders;
  mirrors.hide();
  const bool culls = renderer->GetPass() == nullptr;  // a pass draws all props it gets
  state->counts.counters.drawsCulled = culls ? renderer->GetCulledCount() : 0;
  state->counts.counters.skyCulled = culls && renderer->GetBackdropCulled();
  if (state->tuning != nullptr) state->tuning->frameEnded(window);
  if (!content.many || renderer->GetPass() != nullptr || renderer->GetDrawnGeneration() == seen) return;
  seen = renderer->GetDrawnGeneration();
  std::vector<std::size_t> objects;
  for (const std::size_t i : renderer->GetDrawn()) objects.push_back(content.culled[i]);
  probes.setSeen(std::move(objects));
}

void SceneParts::sync(const Scene& scene, const Changes& changes) {
  makeCurrent();
  frames.dropRays();
  const bool lights = content.setScene(scene, changes.sky) || changes.lights;
  if (state->resources.lightForm != LightForm::Vtk) {
    state->resources.lightForm = scene.energy == Energy::Multiple ? LightForm::Multiple : LightForm::Single;
    state->resources.tone = scene.tone;
  }
  const bool anyProbe = changes.probeList || changes.probeShape;
  // Not while a box is dragged, because dividing objects creates geometry. New models are always shown.
  const bool anew = changes.models && givenAnew;
  if (anew) givenAnew = false;
  const bool divided = (anew || ((changes.models || anyProbe) && !interactive)) && content.divideModels();
  const bool models = changes.models || divided;
  const bool objects = models || changes.materials || changes.objects;
  const bool lit = models || anyProbe || changes.probeTechnique || changes.probeCapture || objects || lights;
  if (models) {
    state->counts.error.clear();
    content.rebuildObjects(renderer, state);
    renderer->RemoveViewProp(ground);
    renderer->AddViewProp(ground);  // above the sky, below glass
    inspector.forgetObjects();
    mirrors.forgetObjects();
  }
  if (objects) {
    for (DrawnObject& object : content.objects) applyOverrides(object, scene);
    content.showObjects(renderer);
    renderer->ForgetHidden();
    applyWindowView();
  }
  // If there are many objects, none is known to be visible before the first frame.
  if (models) probes.setSeen(content.many ? std::optional<std::vector<std::size_t>>(std::in_place) : std::nullopt);
  const bool otherLamps = (objects || lights || anyProbe || changes.probeCapture) && content.findLamps();
  state->resources.lamps = content.lamps;
  if (models || lights || otherLamps) content.rebuildLights(renderer, state->resources);
  content.sky->SetBackground(scene.background, scene.backgroundColor);
  askTraced(objects || changes.exposure || lights);
  if (lit) {
    shadows.sceneChanged();
    suns.sceneChanged();
    probes.updateShapes();
    probes.binder().assign();
  }
  if (objects) mirrors.update();
  if (lit || changes.sky) updateCaptures();
  if (view.any()) applyView();
  if (lit || changes.sky || changes.exposure) frames.sceneChanged();
}

void SceneParts::setWindowView(const WindowView& wanted) {
  if (wanted == windowView) return;
  const bool drawn = !(wanted.hidden == windowView.hidden && wanted.cutaway == windowView.cutaway);
  windowView = wanted;
  makeCurrent();
  applyWindowView();
  if (!drawn) return;
  renderer->ForgetHidden();
  renderer->ForgetDrawn();
  frames.sceneChanged();
}

void SceneParts::applyWindowView() {
  state->cut = windowView.cutaway;
  std::vector<vtkActor*> outlined;
  for (const DrawnObject& object : content.objects) {
    const bool hidden = windowView.hidden.count(object.node) > 0;
    object.pass->SetHiddenInView(hidden);
    if (windowView.outlined.count(object.node) > 0 && !hidden && object.settings.visible)
      outlined.push_back(object.actor);
  }
  setCut(windowView.cutaway.has_value());
  outline.show(outlined);
}

void SceneParts::setCut(bool cut) {
  for (const DrawnObject& object : content.objects) object.pass->SetCut(cut);
}

void SceneParts::askTraced(bool changed) {
  const Scene& scene = content.scene;
  const bool anything = content.sightLines && !content.objects.empty();
  if (!scene.groundShadow || !anything) groundWork.forget();
  if (!scene.ambientOcclusion || !anything) {
    opennessWork.forget();
    state->resources.openness = nullptr;
  }
  if (!changed || !anything || (!scene.groundShadow && !scene.ambientOcclusion)) return;
  const std::string key = hidingKey();
  const auto lines = [scene, models = content.given, maker = content.sightLines] { return maker(scene, models); };
  const Box bounds = content.bounds();
  if (scene.groundShadow) {
    groundWork.ask(key, [lines, bounds](const auto& stop) {
      const auto through = lines();
      return through ? tracedGroundShadow(*through, bounds, stop) : GroundShadow{};
    });
  }
  if (scene.ambientOcclusion) {
    opennessWork.ask(key, [lines, bounds](const auto& stop) {
      const auto through = lines();
      return through ? tracedSkyOpenness(*through, bounds, stop) : SkyOpenness{};
    });
  }
}

void SceneParts::takeOpenness(std::chrono::milliseconds wait) {
  auto known = opennessWork.known(wait);
  if (known && known->empty()) known = nullptr;
  if (known == state->resources.openness) return;
  if (known) state->counts.counters.opennessRays += known->rays;
  state->resources.openness = std::move(known);
  frames.sceneChanged();
}

// Any static object may cast a lamp's shadow into a capture, whether or not the capture shows it.
std::string SceneParts::hidingKey() {
  const bool same = hidingModels.size() == content.given.size() &&
                    std::equal(content.given.begin(), content.given.end(), hidingModels.begin(),
                               [](const auto& now, const auto& before) { return now == before.lock(); });
  if (!same || hidingModelsKey.empty()) {
    hidingModels.assign(content.given.begin(), content.given.end());
    ContentHash hash;
    for (const std::string& key : objectContentKeys(content.given, content.scene.models.size())) hash.add(key);
    hidingModelsKey = hash.text();
  }
  ContentHash hash;
  hash.add(hidingModelsKey);
  for (const ModelFile& file : content.scene.models) {
    const glm::dmat4 placed = worldFromFile(file);
    hash.addBytes(&placed, sizeof placed);
  }
  for (const auto& [node, object] : content.scene.objects) {
    hash.add(node).add(object.visible ? 1 : 0).add(object.dynamic ? 1 : 0);
    if (!object.dynamic) hash.addVector(object.translation).addVector(object.rotationDegrees);
  }
  for (const auto& [name, material] : content.scene.materials) {  // a lampshade does not hide a light source inside it
    if (material.emissive) hash.add(name).add(*material.emissive != glm::vec3(0.0f) ? 1 : 0);
  }
  return hash.text();
}

// Tells the probes what captures of the scene show now.
void SceneParts::updateCaptures() {
  if (contentKeysOf != content.modelGeneration) {
    contentKeys = objectContentKeys(content.models, content.scene.models.size());
    contentKeysOf = content.modelGeneration;
  }
  if (content.skyImage != skyPixelsOf.lock()) {
    skyPixelsOf = content.skyImage;
    skyPixels = content.skyImage ? imageContentKey(*content.skyImage) : std::string();
  }
  CaptureInputs inputs;
  std::vector<PlacedObject> objects;
  objects.reserve(content.objects.size());
  for (const DrawnObject& drawn : content.objects) {
    PlacedObject object;
    object.node = drawn.node;
    object.materialName = drawn.materialName;
    object.contentKey = contentKeys[objects.size()];
    object.worldFromModel = drawn.worldFromModel;
    object.boundsWorld = worldBounds(drawn);
    object.seenByProbes = drawn.settings.seenByProbes;
    object.dynamic = drawn.settings.dynamic;
    object.unlit = drawn.unlit;
    objects.push_back(std::move(object));
    inputs.props.emplace_back(drawn.actor);
  }
  inputs.world = captureWorld(content.scene, objects, skyPixels, probes.plan().entries().places());
  // Lamps drawn as shapes light what a capture shows, even if it does not show them.
  inputs.world.lattices = content.lamps != nullptr;
  if (content.lamps && !content.lamps->lamps.empty()) inputs.world.lights += " " + lampsKey(*content.lamps);
  if (content.lamps && content.sightLines) inputs.world.lights += " traced " + hidingKey();
  if (content.lamps && content.sightLines) inputs.world.latticeSky = inputs.world.sky;
  if (!state->resources.sunShadows.empty()) inputs.world.lights += " suns";
  inputs.sky = inputs.world.sky;
  if (content.skyImage) inputs.skyColumns = content.skyImage->width;
  probes.plan().sources().skyLevels = content.skyImage ? skyLevelsFile(content.skyImageFile()) : std::string();
  probes.updateCaptures(std::move(inputs));
}

void SceneParts::useVtkLighting(int columns, int rows, const std::vector<glm::vec2>& table) {
  window->MakeCurrent();
  makeStaticTextures(window, state->resources, state->counts);
  uploadSplitSumTable(window, state->resources.brdfTable, columns, rows, table);
  state->resources.lightForm = LightForm::Vtk;
  state->resources.tone = Tone::AsVtk;
}

void SceneParts::setProbesEnabled(bool enabled) {
  makeCurrent();
  content.probesDrawn = enabled;
  const bool otherLamps = content.findLamps();
  if (otherLamps) {
    state->resources.lamps = content.lamps;
    content.rebuildLights(renderer, state->resources);
    suns.sceneChanged();
    probes.updateShapes();
    updateCaptures();
  }
  probes.setEnabled(enabled);
}

void SceneParts::setInteractive(bool active) {
  makeCurrent();
  frames.dropRays();
  const bool ended = interactive && !active;
  interactive = active;
  probes.setInteractive(active);
  if (active) return;
  if (!content.divideModels()) {
    if (ended) updateCaptures();  // bounces follow boxes and techniques as they are let go
    return;
  }
  Changes cut;
  cut.models = true;
  sync(content.givenScene(), cut);
}

void SceneParts::step() {
  constexpr std::chrono::milliseconds kTurn(20);
  frames.dropRays();
  makeStaticTextures(window, state->resources, state->counts);
  try {
    if (!probes.workPending()) {
      (groundWork.pending() ? void(groundWork.known(kTurn)) : takeOpenness(kTurn));
      return;
    }
    suns.update();  // captures have them, too
    probes.step();
  } catch (const WorkError& error) {
    // Not rethrown: a window continues without what could not be made, and reports it.
    state->counts.fail(error.what());
    probes.cancelWork();
  }
}

std::vector<Explanation> SceneParts::explain(const std::vector<glm::ivec2>& pixels, int width, int height) {
  window->MakeCurrent();
  frames.dropRays();
  prepareDraws();
  const ScopeExit hidden([this] { mirrors.hide(); });
  drawMirrors(static_cast<double>(width) / height, width, height, kMirrorSamples);
  mirrors.readBack();
  return inspector.explain(renderer->GetActiveCamera(), width, height, pixels);
}

ImageRgbaF SceneParts::renderLinear(int width, int height, int samplesPerPixel,
                                    const std::function<vtkPicturePass*()>& picture,
                                    const std::function<void(int)>& beforeFrame) {
  window->MakeCurrent();
  frames.dropRays();
  probes.tuning().setMoving(false);
  // A program that can cut, and does not, may round the last digit otherwise.
  setCut(false);
  const ScopeExit cutAgain([this] { setCut(windowView.cutaway.has_value()); });
  prepareDraws();
  std::vector<vtkProp*> props = content.shownProps(renderer);
  // The sky has no value in the debug view: it stays transparent.
  if (!view.any()) props.push_back(content.sky);
  const ScopeExit released([this] {
    mirrors.hide();
    frames.dropRays();
    frames.releaseLinear();
  });
  vtkPicturePass* pass = !view.any() ? picture() : nullptr;
  const int finer = samplesPerSide(samplesPerPixel);
  drawMirrors(static_cast<double>(width) / height, width * finer, height * finer, finer > 1 ? 1 : kMirrorSamples);
  return probes.baker().capture()->renderFrame(renderer->GetActiveCamera(), width, height, finer, props,
                                               content.lightPointers(), pass, beforeFrame);
}

ImageRgbaF SceneParts::renderLinear(int width, int height, int samplesPerPixel, int frameLimit,
                                    const std::function<void(int)>& beforeFrame) {
  const auto pass = [&] { return frames.linearPass(frameLimit); };
  return renderLinear(width, height, samplesPerPixel, pass, beforeFrame);
}

ImageRgbaF SceneParts::renderRefined(int width, int height, int samplesPerPixel, const RefineSettings& settings,
                                     const std::function<void(int)>& beforeFrame) {
  const auto pass = [&] { return frames.refinedPass(settings); };
  return renderLinear(width, height, samplesPerPixel, pass, beforeFrame);
}

void SceneParts::refine(const RefineSettings& settings) {
  frames.refine(settings);
  probes.binder().needs().setRefined(settings.rays > 0);
}

void SceneParts::releaseGraphics() {
  if (window == nullptr || state->resources.brdfTable == 0) return;
  window->MakeCurrent();
  frames.release();
  mirrors.release();
  shadows.release();
  suns.release();
  sphere.release();
  outline.release();
  ground->ReleaseGraphicsResources(window);
  probes.release();
  inspector.release();
  state->resources.lattices->release();
  state->resources.sights->release();
  state->resources.lampBlock->release();
  state->resources.opennessTexture->release();
  state->resources.listedLights->release();
  releaseStaticTextures(state->resources);
  for (const DrawnObject& object : content.objects) {
    for (const SurfaceSlot& slot : object.surface->slots) {
      if (slot.texture) slot.texture->release();
    }
  }
  content.sky->ReleaseGraphicsResources(window);
}

}  // namespace boxprobe
