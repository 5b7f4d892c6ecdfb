#include "filters/vtk/scene_renderer.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>

#include <algorithm>
#include <map>
#include <utility>

#include "filters/core/base/scope_exit.h"
#include "filters/core/geometry/probe_diffuse.h"
#include "filters/vtk/gl/program_check.h"
#include "filters/vtk/gl/software_driver.h"
#include "filters/vtk/gl/texture_memory.h"
#include "filters/vtk/gl/window_pixels.h"
#include "filters/vtk/inspect/frame_recorder.h"
#include "filters/vtk/inspect/render_remarks.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/probes/mirror_texels.h"
#include "filters/vtk/scene_renderer_parts.h"

namespace boxprobe {

namespace {

// Does not change the clipping distances.
void setCamera(vtkCamera* to, const Camera& camera) {
  to->SetPosition(camera.position.x, camera.position.y, camera.position.z);
  to->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  to->SetViewUp(camera.up.x, camera.up.y, camera.up.z);
  to->SetViewAngle(camera.verticalFovDegrees);
  to->SetParallelProjection(camera.parallelHeight > 0.0);
  if (camera.parallelHeight > 0.0) to->SetParallelScale(0.5 * camera.parallelHeight);
}

// The name and other values that VTK does not store are defaults.
Camera cameraValues(vtkCamera* from) {
  Camera camera;
  from->GetPosition(&camera.position.x);
  from->GetFocalPoint(&camera.target.x);
  from->GetViewUp(&camera.up.x);
  camera.verticalFovDegrees = from->GetViewAngle();
  camera.parallelHeight = from->GetParallelProjection() != 0 ? 2.0 * from->GetParallelScale() : 0.0;
  return camera;
}

}  // namespace

struct SceneRenderer::Impl : SceneParts {
  using SceneParts::SceneParts;
};

SceneRenderer::SceneRenderer(vtkOpenGLRenderWindow* window) : impl_(std::make_unique<Impl>(window)) {}

SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::setModels(std::vector<std::shared_ptr<const Model>> models) {
  impl_->content.given = std::move(models);
  impl_->givenAnew = true;
}

void SceneRenderer::setSightLines(SightLinesMaker lines) {
  impl_->content.sightLines = std::move(lines);
}

void SceneRenderer::sync(const Scene& scene, const Changes& changes) {
  impl_->sync(scene, changes);
}

void SceneRenderer::setView(const SurfaceViewSettings& settings) {
  if (view() == settings) return;
  impl_->frames.dropRays();
  impl_->view.set(settings);
  impl_->probes.tuning().setMoving(false);
  impl_->applyView();
}

void SceneRenderer::setDiffuseTruth(ImageRgbaF light) {
  impl_->view.setTruth(std::move(light));
}

const SurfaceViewSettings& SceneRenderer::view() const {
  return impl_->view.settings();
}

std::pair<double, double> SceneRenderer::viewRange() const {
  return impl_->view.range(impl_->content);
}

Explanation SceneRenderer::explain(int x, int y, int width, int height) {
  return explain({glm::ivec2(x, y)}, width, height).front();
}

std::vector<Explanation> SceneRenderer::explain(const std::vector<glm::ivec2>& pixels, int width, int height) {
  std::vector<Explanation> explained = impl_->explain(pixels, width, height);
  for (Explanation& e : explained) e.tracedIrradiance = impl_->view.truthAt(e.x, e.y, width, height);
  return explained;
}

void SceneRenderer::setInteractive(bool interactive) {
  impl_->setInteractive(interactive);
}

void SceneRenderer::useVtkLighting(int columns, int rows, const std::vector<glm::vec2>& table) {
  impl_->useVtkLighting(columns, rows, table);
}

void SceneRenderer::useGeneralPrograms(bool generally) {
  tune(generally ? TuningParts{0} : TuningParts{kAllTuning});
}

void SceneRenderer::tune(TuningParts parts) {
  impl_->makeCurrent();
  impl_->probes.tuning().setParts(parts);
  impl_->probes.setTuned(parts != 0);
  impl_->renderer->SetHiddenCulling((parts & kTunedHidden) != 0);
}

void SceneRenderer::disableParts(FrameParts parts, const std::vector<std::size_t>& objects, bool sky) {
  auto& all = impl_->content.objects;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool meant = objects.empty() || std::find(objects.begin(), objects.end(), i) != objects.end();
    all[i].pass->SetDisabledParts(meant ? parts : 0);
  }
  impl_->content.sky->SetVisibility(sky ? 0 : 1);
  impl_->ground->SetVisibility((parts & (kGroundPart | kObjectPart)) != 0 ? 0 : 1);
  impl_->renderer->ForgetHidden();
}

void SceneRenderer::drawHidden(bool hidden) {
  impl_->renderer->SetHiddenCulling(!hidden);
}

void SceneRenderer::keepDepth(bool keep) {
  impl_->renderer->SetPreserveDepthBuffer(keep ? 1 : 0);
}

std::vector<DrawnProgram> SceneRenderer::drawnPrograms() const {
  return boxprobe::drawnPrograms(impl_->content);
}

void SceneRenderer::setEditable(bool editable) {
  impl_->probes.tuning().setEditable(editable);
  impl_->state->resources.latticesBeside = editable;
}

void SceneRenderer::showCoarseFirst(bool coarse) {
  impl_->makeCurrent();
  impl_->probes.setCoarseFirst(coarse);
}

void SceneRenderer::allowStandIns(bool allowed) {
  impl_->makeCurrent();
  impl_->probes.tuning().allowStandIns(allowed);
}

bool SceneRenderer::setMoving(bool moving) {
  impl_->frames.dropRays();
  return impl_->probes.tuning().setMoving(moving && !impl_->view.any());
}

void SceneRenderer::specializePrograms() {
  impl_->frames.dropRays();
  impl_->probes.tuning().makeConstants();
}

bool SceneRenderer::workPending() const {
  return impl_->workPending();
}

bool SceneRenderer::step() {
  impl_->step();
  return workPending();
}

double SceneRenderer::workProgress() const {
  return impl_->probes.progress();
}

WorkNow SceneRenderer::workNow() const {
  return impl_->workPending() ? impl_->probes.workNow() : WorkNow{};
}

bool SceneRenderer::finishWork(const std::function<bool(double)>& progress) {
  impl_->window->MakeCurrent();
  // If there are many probes, those needed are known after a frame has shown which objects are visible.
  if (impl_->content.many && impl_->probes.followsSeen() && !impl_->renderer->DrawnIsCurrent()) impl_->window->Render();
  while (workPending()) {
    step();
    if (progress && !progress(workProgress())) return false;
  }
  return true;
}

void SceneRenderer::setProbesEnabled(bool enabled) {
  impl_->setProbesEnabled(enabled);
}

void SceneRenderer::applyCamera(const Camera& camera) {
  setCamera(impl_->renderer->GetActiveCamera(), camera);
}

Camera SceneRenderer::currentCamera() const {
  return cameraValues(impl_->renderer->GetActiveCamera());
}

vtkRenderer* SceneRenderer::renderer() const {
  return impl_->renderer;
}

Box SceneRenderer::bounds() const {
  return impl_->content.bounds();
}

ImageRgba8 SceneRenderer::renderDisplay() {
  impl_->window->Render();
  return windowPixels(impl_->window);
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
  return impl_->renderLinear(width, height, samplesPerPixel, frames, beforeFrame);
}

void SceneRenderer::refine(const RefineSettings& settings) {
  impl_->makeCurrent();
  impl_->refine(settings);
}

void SceneRenderer::sharpenMirrors(int rows) {
  impl_->makeCurrent();
  impl_->probes.setSharp(
      rows > 0 ? mirrorFaceSizes(impl_->content, impl_->renderer->GetActiveCamera(), rows, textureMemoryLimit() / 4)
               : std::map<std::string, int>());
}

const RefineSettings& SceneRenderer::refineSettings() const {
  return impl_->frames.refineSettings();
}

RefineState SceneRenderer::refineState() const {
  const Refinement& stages = impl_->frames.refinement();
  return {stages.raysDone(), stages.more(), stages.left()};
}

ImageRgbaF SceneRenderer::renderRefined(int width, int height, int samplesPerPixel, const RefineSettings& settings,
                                        const std::function<void(int)>& beforeFrame) {
  return impl_->renderRefined(width, height, samplesPerPixel, settings, beforeFrame);
}

std::shared_ptr<const BakedMaps> SceneRenderer::mapsOnCpu(const std::string& probeName) {
  impl_->window->MakeCurrent();
  const auto maps = probeName.empty() ? impl_->state->resources.sky : impl_->probes.maps(probeName);
  if (maps) maps->need(kAllLevels);
  return impl_->inspector.onCpu(maps);
}

std::shared_ptr<const BakedMaps> SceneRenderer::explainedMaps(const std::string& probeName) {
  impl_->window->MakeCurrent();
  return impl_->inspector.onCpu(probeName.empty() ? impl_->state->resources.sky : impl_->probes.maps(probeName));
}

void SceneRenderer::useBakedFiles(const std::string& folder) {
  impl_->makeCurrent();
  impl_->probes.useBakedFiles(folder);
}

void SceneRenderer::setBakeTargets(const std::vector<std::string>& probes, const std::vector<std::string>& cutShort) {
  impl_->makeCurrent();
  impl_->probes.setBakeTargets(probes, cutShort);
}

void SceneRenderer::requestBake(const std::vector<std::string>& probes) {
  impl_->makeCurrent();
  impl_->probes.requestBake(probes);
  impl_->updateCaptures();
}

BakeState SceneRenderer::bakeState(const std::string& probeName) const {
  return impl_->probes.plan().state(probeName);
}

std::vector<std::string> SceneRenderer::bakeKeys(const std::string& probeName) const {
  return impl_->probes.bakeKeys(probeName);
}

std::string SceneRenderer::rendererName() const {
  impl_->makeCurrent();
  return boxprobe::rendererName();
}

std::string SceneRenderer::saveBaked(const std::string& probeName, const std::string& folder,
                                     const std::string& program, int earlierBounce) const {
  const auto record = impl_->probes.plan().record(probeName);
  auto maps = record ? readMaps(probeName) : std::nullopt;
  if (!maps) return {};
  Probe probe;
  probe.name.clear();
  if (const auto index = findProbe(impl_->content.scene, probeName)) probe = impl_->content.scene.probes[*index];
  return BakeFolder::save(folder, probe, *record, std::move(*maps), {program, rendererName()}, earlierBounce);
}

bool SceneRenderer::filterMissingLevel(const std::string& probeName) {
  const auto maps = probeName.empty() ? impl_->state->resources.sky : impl_->probes.maps(probeName);
  const LevelMask missing = maps ? maps->missing(kAllLevels) : 0;
  if (missing == 0) return false;
  impl_->window->MakeCurrent();
  maps->need(missing & (~missing + 1));
  return true;
}

const std::string& SceneRenderer::pictureError() const {
  return impl_->probes.plan().sources().pictures.error();
}

std::vector<std::string> SceneRenderer::remarks() const {
  std::vector<std::string> texts = impl_->probes.sourceRemarks();
  const std::vector<std::string> more = sceneRemarks(impl_->content, frameReport(), counters());
  texts.insert(texts.end(), more.begin(), more.end());
  return texts;
}

std::optional<BakedMaps> SceneRenderer::readMaps(const std::string& probeName) const {
  const auto maps = probeName.empty() ? impl_->state->resources.sky : impl_->probes.maps(probeName);
  if (!maps) return std::nullopt;
  impl_->window->MakeCurrent();
  return readBack(*maps);
}

std::shared_ptr<const ProbeMaps> SceneRenderer::shownMaps(const std::string& probeName) const {
  return impl_->probes.maps(probeName);
}

ProbesDiffuse SceneRenderer::probesDiffuse() const {
  ProbesDiffuse diffuse;
  for (std::size_t i = 0; i < impl_->content.scene.probes.size(); ++i) {
    diffuse.probes.push_back(impl_->probes.diffuseLight(i));
  }
  if (!impl_->content.lamps) return diffuse;
  for (const SceneLamp& lamp : impl_->content.lamps->lamps) {
    if (lamp.light) diffuse.countedLights.insert(*lamp.light);
  }
  return diffuse;
}

void SceneRenderer::showPreviewSphere(const PreviewSphereSettings& settings) {
  impl_->sphere.show(settings);
}

const PreviewSphereSettings& SceneRenderer::previewSphere() const {
  return impl_->sphere.settings();
}

void SceneRenderer::setWindowView(const WindowView& view) {
  impl_->setWindowView(view);
}

const WindowView& SceneRenderer::windowView() const {
  return impl_->windowView;
}

std::optional<Box> SceneRenderer::objectBounds(const std::string& node) const {
  std::optional<Box> bounds;
  for (const DrawnObject& object : impl_->content.objects) {
    if (object.node != node || !object.settings.visible) continue;
    const Box box = worldBounds(object);
    bounds = bounds ? Box{glm::min(bounds->min, box.min), glm::max(bounds->max, box.max)} : box;
  }
  return bounds;
}

FrameReport SceneRenderer::frameReport() const {
  return reportFrame(impl_->content, impl_->probes, impl_->mirrors, counters());
}

FrameReport::Lookups SceneRenderer::measureLookups(int width, int height) {
  const SurfaceViewSettings kept = view();
  SurfaceViewSettings settings;
  settings.view = *findSurfaceView("lookups");
  setView(settings);
  const ScopeExit shownAgain([&] { setView(kept); });
  return lookupsOf(renderLinear(width, height, 1));
}

const Counters& SceneRenderer::counters() const {
  return impl_->state->counts.counters;
}
const Times& SceneRenderer::times() const {
  return impl_->probes.baker().times();
}

std::size_t SceneRenderer::probeMemoryBytes() const {
  return impl_->probes.memoryBytes();
}

std::string SceneRenderer::error() const {
  if (!impl_->state->counts.error.empty()) return impl_->state->counts.error;
  const auto& objects = impl_->content.objects;
  const bool refused = std::any_of(objects.begin(), objects.end(),
                                   [](const DrawnObject& object) { return object.pass->GetDebugRefused(); });
  return refused ? kViewRefused : impl_->probes.plan().memoryError();
}

void SceneRenderer::releaseGraphics() {
  impl_->releaseGraphics();
}

}  // namespace boxprobe
