#include "filters/vtk/scene_renderer.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/base/errors.h"
#include "filters/vtk/capture/cube_capture.h"
#include "filters/vtk/frame/mirror_set.h"
#include "filters/vtk/frame/moving_shadows.h"
#include "filters/vtk/frame/picture_frames.h"
#include "filters/vtk/inspect/frame_recorder.h"
#include "filters/vtk/inspect/glass_remarks.h"
#include "filters/vtk/inspect/preview_sphere.h"
#include "filters/vtk/inspect/surface_inspector.h"
#include "filters/vtk/inspect/view_legend.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/probes/probe_set.h"
#include "filters/vtk/scene/scene_content.h"
#include "filters/vtk/scene/vtkCulledRenderer.h"
#include "filters/vtk/surface/static_textures.h"

namespace boxprobe {

struct SceneRenderer::Impl {
  explicit Impl(vtkOpenGLRenderWindow* w)
      : window(w),
        state(std::make_shared<DrawState>()),
        capture(w, state),
        probes(w, state, &capture, &content, &times),
        inspector(w, state, &content),
        frames(w, renderer, state, &content),
        mirrors(w, state, &content),
        sphere(w, renderer, state),
        shadows(w, state, &content) {}

  vtkOpenGLRenderWindow* window;
  std::shared_ptr<DrawState> state;
  Times times;
  vtkNew<vtkCulledRenderer> renderer;
  std::uint64_t seen = 0;  ///< generation of what the renderer drew that the probes know of
  vtkNew<vtkCallbackCommand> frameObserver;
  SceneContent content;
  CubeCapture capture;
  ProbeSet probes;
  SurfaceInspector inspector;
  PictureFrames frames;
  MirrorSet mirrors;
  PreviewSphere sphere;
  MovingShadows shadows;
  ViewLegend legend;
  SurfaceViewSettings view;
  bool interactive = false;

  void makeCurrent();
  void drawMirrors(vtkCamera* camera, double aspect, int width, int height, int samples);
  void beginFrame();
  void endFrame();
  void resetClippingRange();
  std::pair<double, double> viewRange() const;
  void applyView();
};

// Of a texel of a planar mirror's picture, where it is drawn for as many pixels as the screen has.
constexpr int kMirrorSamples = 4;

// To two digits: the ends of a scale should be readable numbers.
double roundedUp(double x) {
  const double digit = std::pow(10.0, std::floor(std::log10(std::max(x, 1.0e-30))) - 1.0);
  return std::ceil(x / digit) * digit;
}

// A row without a range of its own takes one from the scene: distances up to the largest box's diagonal, which no ray
// inside of it exceeds, levels up to the longest chain.
std::pair<double, double> SceneRenderer::Impl::viewRange() const {
  const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(view.view)];
  double low = row.low, high = row.high;
  if (row.kind == ViewKind::Scalar && low == high) {
    if (row.id == "level") {
      for (const Probe& probe : content.scene.probes) high = std::max(high, prefilterLevels(probe.faceSize) - 1.0);
    } else {
      double diagonal = 0.0;
      for (const Probe& probe : content.scene.probes) diagonal = std::max(diagonal, glm::length(probe.box.size()));
      if (diagonal == 0.0) diagonal = glm::length(content.bounds().size());
      high = roundedUp(row.id == "hit-error" ? 0.1 * diagonal : diagonal);
    }
    if (high <= low) high = low + 1.0;
  }
  return {view.low.value_or(low), view.high.value_or(high)};
}

void SceneRenderer::Impl::applyView() {
  for (DrawnObject& object : content.objects) object.mapper->SetDebug(view.view != 0);
  const auto [low, high] = viewRange();
  state->debug.view = view.view;
  state->debug.low = static_cast<float>(low);
  state->debug.high = static_cast<float>(high);
  std::vector<std::string> names;
  for (const Probe& probe : content.scene.probes) names.push_back(probe.name);
  legend.show(renderer, surfaceViews()[static_cast<std::size_t>(view.view)], low, high, names);
}

// Maps that are replaced, and those under way that are given up, are deleted, which needs their context.
void SceneRenderer::Impl::makeCurrent() {
  if (state->brdfTable != 0) window->MakeCurrent();
}

void SceneRenderer::Impl::beginFrame() {
  makeStaticTextures(window, *state);
  if (view.view != 0) legend.upload(window, state->debug);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  state->exposure = static_cast<float>(content.scene.exposure);
  state->counters.drawsByProbeCount = {};
  state->counters.drawsWithOpenSky = state->counters.drawsWithCoverage = 0;
  state->counters.glassDraws = state->counters.glassPasses = 0;
  shadows.update();
  resetClippingRange();
  frames.beginFrame(view.view != 0);
  if (sphere.shown()) {
    const auto index = findProbe(content.scene, sphere.settings().probe);
    sphere.follow(index ? &content.scene.probes[*index] : nullptr, probes.maps(sphere.settings().probe));
  }
  const int* size = renderer->GetSize();
  drawMirrors(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio(), size[0], size[1], kMirrorSamples);
}

void SceneRenderer::Impl::drawMirrors(vtkCamera* camera, double aspect, int width, int height, int samples) {
  try {
    mirrors.draw(camera, aspect, width, height, samples);
  } catch (const Error& failure) {
    mirrors.hide();
    if (state->error.empty()) state->error = failure.what();
  }
}

// Of many objects those in the view count: how far the rest reaches would only cost depth.
void SceneRenderer::Impl::resetClippingRange() {
  if (!content.many) return renderer->ResetCameraClippingRange();
  Box box;
  bool any = false;
  for (const std::size_t i : renderer->InView()) {
    const Box b = worldBounds(content.objects[content.culled[i]]);
    box = any ? Box{glm::min(box.min, b.min), glm::max(box.max, b.max)} : b;
    any = true;
  }
  if (!any) box = content.culledBounds;
  const double bounds[6] = {box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z};
  renderer->ResetCameraClippingRange(bounds);
}

void SceneRenderer::Impl::endFrame() {
  ++state->counters.renders;
  mirrors.hide();
  if (!content.many || renderer->GetPass() != nullptr || renderer->GetDrawnGeneration() == seen) return;
  seen = renderer->GetDrawnGeneration();
  std::vector<std::size_t> objects;
  for (const std::size_t i : renderer->GetDrawn()) objects.push_back(content.culled[i]);
  probes.setSeen(std::move(objects));
}

SceneRenderer::SceneRenderer(vtkOpenGLRenderWindow* window) : impl_(std::make_unique<Impl>(window)) {
  Impl& d = *impl_;
  d.content.sky->SetDrawState(d.state);
  d.renderer->AutomaticLightCreationOff();
  d.renderer->SetLightFollowCamera(false);
  d.renderer->SetBackground(0.0, 0.0, 0.0);
  d.frameObserver->SetClientData(&d);
  d.frameObserver->SetCallback([](vtkObject*, unsigned long event, void* client, void*) {
    auto* impl = static_cast<Impl*>(client);
    if (event == vtkCommand::StartEvent) {
      impl->beginFrame();
    } else {
      impl->endFrame();
    }
  });
  d.renderer->AddObserver(vtkCommand::StartEvent, d.frameObserver);
  d.renderer->AddObserver(vtkCommand::EndEvent, d.frameObserver);
  window->AddRenderer(d.renderer);
}

SceneRenderer::~SceneRenderer() {
  releaseGraphics();
  impl_->renderer->RemoveObserver(impl_->frameObserver);
  impl_->window->RemoveRenderer(impl_->renderer);
}

void SceneRenderer::setModels(std::vector<std::shared_ptr<const Model>> models) {
  impl_->content.given = std::move(models);
}

void SceneRenderer::sync(const Scene& scene, const Changes& changes) {
  Impl& d = *impl_;
  SceneContent& content = d.content;
  d.makeCurrent();
  content.scene = scene;
  const bool anyProbe = changes.probeList || changes.probeShape;
  // Not while a box is dragged: cutting makes geometry anew.
  const bool divided = (changes.models || anyProbe) && !d.interactive && content.divideModels();
  const bool models = changes.models || divided;
  const bool objects = models || changes.materials || changes.objects;
  const bool probes =
      models || changes.probeList || changes.probeShape || changes.probeTechnique || changes.probeCapture;
  if (models) {
    d.state->error.clear();
    content.rebuildObjects(d.renderer, d.state);
    d.inspector.forgetObjects();
    d.mirrors.forgetObjects();
  }
  if (objects) {
    for (DrawnObject& object : content.objects) applyOverrides(object, scene);
  }
  if (objects) {
    content.showObjects(d.renderer);
    // Of many objects none has been seen yet: the first frame will tell.
    if (models) {
      d.probes.setSeen(content.many ? std::optional<std::vector<std::size_t>>(std::in_place) : std::nullopt);
    }
  }
  if (models || changes.lights) content.rebuildLights(d.renderer);
  if (changes.sky) content.rebuildSky();
  if (objects || probes || changes.lights) {
    d.shadows.sceneChanged();
    d.probes.updateShapes();
    d.probes.assignToObjects();
  }
  if (objects) d.mirrors.update();
  if (objects || probes || changes.lights || changes.sky) d.probes.updateCaptures();
  if (d.view.view != 0) d.applyView();
  if (objects || probes || changes.lights || changes.sky || changes.exposure) d.frames.sceneChanged();
}

void SceneRenderer::setView(const SurfaceViewSettings& settings) {
  if (impl_->view == settings) return;
  impl_->view = settings;
  impl_->probes.setMoving(false);
  impl_->applyView();
}

const SurfaceViewSettings& SceneRenderer::view() const {
  return impl_->view;
}

std::pair<double, double> SceneRenderer::viewRange() const {
  return impl_->viewRange();
}

Explanation SceneRenderer::explain(int x, int y, int width, int height) {
  return explain({glm::ivec2(x, y)}, width, height).front();
}

std::vector<Explanation> SceneRenderer::explain(const std::vector<glm::ivec2>& pixels, int width, int height) {
  Impl& d = *impl_;
  d.window->MakeCurrent();
  makeStaticTextures(d.window, *d.state);
  d.shadows.update();
  d.resetClippingRange();
  vtkCamera* camera = d.renderer->GetActiveCamera();
  d.drawMirrors(camera, static_cast<double>(width) / height, width, height, kMirrorSamples);
  d.mirrors.readBack();
  std::vector<Explanation> result = d.inspector.explain(camera, width, height, pixels);
  d.mirrors.hide();
  // The surface capture left its camera's lighting uniforms behind in shared programs; see CubeCapture::renderInto.
  camera->Modified();
  return result;
}

void SceneRenderer::setInteractive(bool interactive) {
  Impl& d = *impl_;
  d.makeCurrent();
  d.interactive = interactive;
  d.probes.setInteractive(interactive);
  if (interactive || !d.content.divideModels()) return;
  Changes cut;
  cut.models = true;
  const Scene scene = d.content.scene;
  sync(scene, cut);
}

void SceneRenderer::setEditable(bool editable) {
  impl_->probes.setEditable(editable);
}

void SceneRenderer::allowStandIns(bool allowed) {
  impl_->makeCurrent();
  impl_->probes.allowStandIns(allowed);
}

bool SceneRenderer::setMoving(bool moving) {
  return impl_->probes.setMoving(moving && impl_->view.view == 0);
}

bool SceneRenderer::workPending() const {
  return impl_->probes.workPending();
}

bool SceneRenderer::step() {
  Impl& d = *impl_;
  makeStaticTextures(d.window, *d.state);
  try {
    d.probes.step();
  } catch (const WorkError& error) {
    // Not thrown on: a window goes on without what could not be made, and says so.
    if (d.state->error.empty()) d.state->error = error.what();
    d.probes.giveUp();
  }
  // The captures left their camera's lighting uniforms behind in shared programs; see CubeCapture::renderInto.
  d.renderer->GetActiveCamera()->Modified();
  return workPending();
}

double SceneRenderer::workProgress() const {
  return impl_->probes.progress();
}

bool SceneRenderer::finishWork(const std::function<bool(double)>& progress) {
  impl_->window->MakeCurrent();
  // Which of many probes are needed is known once a frame has shown what is seen.
  if (impl_->content.many && impl_->probes.followsSeen() && !impl_->renderer->DrawnIsCurrent()) impl_->window->Render();
  while (workPending()) {
    step();
    if (progress && !progress(workProgress())) return false;
  }
  return true;
}

void SceneRenderer::setProbesEnabled(bool enabled) {
  impl_->makeCurrent();
  impl_->probes.setEnabled(enabled);
}

void SceneRenderer::applyCamera(const Camera& camera) {
  vtkCamera* vtk = impl_->renderer->GetActiveCamera();
  vtk->SetPosition(camera.position.x, camera.position.y, camera.position.z);
  vtk->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  vtk->SetViewUp(camera.up.x, camera.up.y, camera.up.z);
  vtk->SetViewAngle(camera.verticalFovDegrees);
  vtk->SetParallelProjection(camera.parallelHeight > 0.0);
  if (camera.parallelHeight > 0.0) vtk->SetParallelScale(0.5 * camera.parallelHeight);
}

Camera SceneRenderer::currentCamera() const {
  vtkCamera* vtk = impl_->renderer->GetActiveCamera();
  Camera camera;
  vtk->GetPosition(&camera.position.x);
  vtk->GetFocalPoint(&camera.target.x);
  vtk->GetViewUp(&camera.up.x);
  camera.verticalFovDegrees = vtk->GetViewAngle();
  camera.parallelHeight = vtk->GetParallelProjection() != 0 ? 2.0 * vtk->GetParallelScale() : 0.0;
  return camera;
}

vtkRenderer* SceneRenderer::renderer() const {
  return impl_->renderer;
}

Box SceneRenderer::bounds() const {
  return impl_->content.bounds();
}

ImageRgba8 SceneRenderer::renderDisplay() {
  vtkOpenGLRenderWindow* window = impl_->window;
  window->Render();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  // VTK 9.1 reads three bytes a pixel into rows without padding, whatever the alignment is: rows of an odd width would
  // run over the array's end.
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels, 0);
  ImageRgba8 image{size[0], size[1], {}, {}};
  image.pixels.resize(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * 4);
  for (int y = 0; y < size[1]; ++y) {
    const unsigned char* row = pixels->GetPointer(3 * static_cast<vtkIdType>(size[1] - 1 - y) * size[0]);
    std::uint8_t* out = &image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size[0]) * 4];
    for (std::ptrdiff_t x = 0; x < size[0]; ++x) {
      out[4 * x] = row[3 * x];
      out[4 * x + 1] = row[3 * x + 1];
      out[4 * x + 2] = row[3 * x + 2];
      out[4 * x + 3] = 255;
    }
  }
  return image;
}

bool SceneRenderer::averagesFrames() const {
  return impl_->frames.averages();
}

FrameCount SceneRenderer::frameCount() const {
  return impl_->frames.count();
}

void SceneRenderer::restartPicture() {
  impl_->frames.sceneChanged();
}

void SceneRenderer::setFrameLimit(std::optional<int> frames) {
  impl_->frames.setLimit(frames);
}

ImageRgbaF SceneRenderer::renderLinear(int width, int height, int samplesPerPixel, int frames,
                                       const std::function<void(int)>& beforeFrame) {
  Impl& d = *impl_;
  d.window->MakeCurrent();
  d.probes.setMoving(false);
  makeStaticTextures(d.window, *d.state);
  d.shadows.update();
  d.resetClippingRange();
  std::vector<vtkProp*> props = d.content.shownProps(d.renderer);
  // The sky has no value in the debug view: it stays transparent.
  if (d.view.view == 0) props.push_back(d.content.sky);
  vtkCamera* camera = d.renderer->GetActiveCamera();
  vtkPicturePass* pass = d.view.view == 0 ? d.frames.linearPass(frames) : nullptr;
  const int finer = samplesPerSide(samplesPerPixel);
  d.drawMirrors(camera, static_cast<double>(width) / height, width * finer, height * finer,
                finer > 1 ? 1 : kMirrorSamples);
  ImageRgbaF image = d.capture.renderFrame(camera, width, height, samplesPerSide(samplesPerPixel), props,
                                           d.content.lightPointers(), pass, beforeFrame);
  d.mirrors.hide();
  d.frames.releaseLinear();
  camera->Modified();
  return image;
}

std::shared_ptr<const BakedMaps> SceneRenderer::mapsOnCpu(const std::string& probeName) {
  impl_->window->MakeCurrent();
  return impl_->inspector.onCpu(probeName.empty() ? impl_->state->sky : impl_->probes.maps(probeName));
}

void SceneRenderer::useBakedFiles(const std::string& folder) {
  impl_->makeCurrent();
  impl_->probes.useBakedFiles(folder);
}

void SceneRenderer::setBakeTargets(const std::vector<std::string>& probes) {
  impl_->makeCurrent();
  impl_->probes.setBakeTargets(probes);
}

void SceneRenderer::requestBake(const std::vector<std::string>& probes) {
  impl_->makeCurrent();
  impl_->probes.requestBake(probes);
}

BakeState SceneRenderer::bakeState(const std::string& probeName) const {
  return impl_->probes.bakeState(probeName);
}

std::string SceneRenderer::saveBaked(const std::string& probeName, const std::string& folder,
                                     const std::string& program) const {
  const auto record = impl_->probes.record(probeName);
  const auto maps = record ? readMaps(probeName) : std::nullopt;
  if (!maps) return {};
  Probe probe;
  probe.name.clear();
  if (const auto index = findProbe(impl_->content.scene, probeName)) probe = impl_->content.scene.probes[*index];
  return BakeFolder::save(folder, probe, *record, *maps, program);
}

const std::string& SceneRenderer::pictureError() const {
  return impl_->probes.pictureError();
}

std::vector<std::string> SceneRenderer::remarks() const {
  const Impl& d = *impl_;
  std::vector<std::string> texts = d.probes.pictureRemarks();
  const auto* image = std::get_if<SkyImage>(&d.content.scene.sky);
  if (image != nullptr && d.content.skyTexelsNotFinite > 0) {
    texts.push_back("sky.image: " + image->file + ": " + std::to_string(d.content.skyTexelsNotFinite) +
                    " texels are NaN or infinite and were set to 0");
  }
  const std::vector<std::string> leftOut = leftOutLines(frameReport());
  constexpr std::size_t kNamed = 5;
  const std::vector<std::string> glass = glassRemarks(d.content);
  texts.insert(texts.end(), glass.begin(), glass.begin() + static_cast<long>(std::min(glass.size(), kNamed)));
  texts.insert(texts.end(), leftOut.begin(), leftOut.begin() + static_cast<long>(std::min(leftOut.size(), kNamed)));
  if (leftOut.size() > kNamed) {
    texts.push_back("and " + std::to_string(leftOut.size() - kNamed) + " more objects that more probes reach");
  }
  const Counters& counters = d.state->counters;
  if (counters.texelsNotFinite > 0) {
    texts.push_back(std::to_string(counters.texelsNotFinite) +
                    " captured samples were NaN or infinite and were set to 0");
  }
  if (counters.texelsClamped > 0) {
    texts.push_back(
        std::to_string(counters.texelsClamped) +
        " captured samples were brighter than 65504, the most a half float holds, and were brought down to it");
  }
  return texts;
}

std::optional<BakedMaps> SceneRenderer::readMaps(const std::string& probeName) const {
  const auto maps = probeName.empty() ? impl_->state->sky : impl_->probes.maps(probeName);
  if (!maps) return std::nullopt;
  impl_->window->MakeCurrent();
  return readBack(*maps);
}

std::shared_ptr<const ProbeMaps> SceneRenderer::shownMaps(const std::string& probeName) const {
  return impl_->probes.maps(probeName);
}

void SceneRenderer::showPreviewSphere(const PreviewSphereSettings& settings) {
  impl_->sphere.show(settings);
}

const PreviewSphereSettings& SceneRenderer::previewSphere() const {
  return impl_->sphere.settings();
}

FrameReport SceneRenderer::frameReport() const {
  FrameReport report = reportFrame(impl_->content, impl_->probes, *impl_->state);
  for (const MirrorReport& m : impl_->mirrors.reports()) {
    report.mirrors.push_back(
        {m.node, m.state == MirrorState::Drawn, mirrorStateText(m.state), m.width, m.height, m.objects, m.hiding});
  }
  report.mirrorBytes = impl_->mirrors.memoryBytes();
  return report;
}

FrameReport::Lookups SceneRenderer::measureLookups(int width, int height) {
  const SurfaceViewSettings kept = impl_->view;
  SurfaceViewSettings settings;
  settings.view = *findSurfaceView("lookups");
  setView(settings);
  const ImageRgbaF image = renderLinear(width, height, 1);
  setView(kept);
  FrameReport::Lookups lookups;
  std::size_t surfaces = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    if (image.pixels[i + 3] <= 0.0f) continue;
    const double here = std::max(0.0, static_cast<double>(image.pixels[i]));
    lookups.mean += here;
    lookups.most = std::max(lookups.most, here);
    ++surfaces;
  }
  lookups.mean /= static_cast<double>(std::max(surfaces, std::size_t{1}));
  return lookups;
}

const Counters& SceneRenderer::counters() const {
  return impl_->state->counters;
}
const Times& SceneRenderer::times() const {
  return impl_->times;
}

std::size_t SceneRenderer::probeMemoryBytes() const {
  return impl_->probes.memoryBytes();
}

std::string SceneRenderer::error() const {
  return impl_->state->error.empty() ? impl_->probes.memoryError() : impl_->state->error;
}

void SceneRenderer::releaseGraphics() {
  Impl& d = *impl_;
  if (d.window == nullptr || d.state->brdfTable == 0) return;
  d.window->MakeCurrent();
  d.frames.release();
  d.mirrors.release();
  d.shadows.release();
  d.sphere.release();
  d.probes.release();
  d.capture.release();
  d.inspector.release();
  if (d.state->debug.colorMap != 0) glDeleteTextures(1, &d.state->debug.colorMap);
  d.state->debug.colorMap = 0;
  releaseStaticTextures(*d.state);
  for (const DrawnObject& object : d.content.objects) {
    for (const SurfaceSlot& slot : object.surface->slots) {
      if (slot.texture) slot.texture->release();
    }
  }
  d.content.sky->ReleaseGraphicsResources(d.window);
}

}  // namespace boxprobe
