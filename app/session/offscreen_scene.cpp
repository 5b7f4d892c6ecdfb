// See offscreen_scene.h.
#include "app/session/offscreen_scene.h"

#include <vtkRenderer.h>

#include <utility>

#include "app/session/vtk_messages.h"
#include "filters/core/base/errors.h"
#include "filters/fit/rays/triangle_sight.h"
#include "filters/vtk/gl/cpu_time.h"

namespace boxprobe {

OffscreenScene::OffscreenScene(const OffscreenSettings& settings) : OffscreenScene(openOffscreenWindow(settings)) {}

OffscreenScene::OffscreenScene(vtkSmartPointer<vtkOpenGLRenderWindow> window)
    : window_(std::move(window)), renderer_(std::make_unique<SceneRenderer>(window_)), toldBefore_(firstVtkError()) {
  renderer_->setSightLines(traceSightLines);
}

OffscreenScene::~OffscreenScene() {
  window_->MakeCurrent();
  renderer_.reset();
}

void OffscreenScene::show(const Scene& scene, const Models& models, const ShownSettings& settings) {
  window_->MakeCurrent();
  renderer_->setProbesEnabled(settings.probes);
  // The folder is looked at once: files written since then are not taken for those of a scene that was read before.
  if (settings.bakedFolder != bakedFolder_) renderer_->useBakedFiles(settings.bakedFolder);
  bakedFolder_ = settings.bakedFolder;
  const bool sameModels = shown_ && models == models_;
  if (!sameModels) renderer_->setModels(models);
  renderer_->sync(scene, sameModels ? difference(*shown_, scene) : Changes::all());
  shown_ = scene;
  models_ = models;
  if (settings.camera) renderer_->applyCamera(*settings.camera);
  renderer_->setView(settings.view);
  if (settings.bakeTargets != bakeTargets_ || settings.cutShort != cutShort_) {
    renderer_->setBakeTargets(settings.bakeTargets, settings.cutShort);
  }
  bakeTargets_ = settings.bakeTargets;
  cutShort_ = settings.cutShort;
  if (!renderer_->pictureError().empty()) throw InputError(renderer_->pictureError());
}

bool OffscreenScene::capture(const std::function<bool(double)>& progress) {
  window_->MakeCurrent();
  return renderer_->finishWork(progress);
}

void OffscreenScene::requireHealthy() const {
  if (!renderer_->error().empty()) throw WorkError(renderer_->error());
  if (firstVtkError() != toldBefore_) throw WorkError(firstVtkError());
}

void OffscreenScene::rest() {
  window_->MakeCurrent();
  renderer_->specializePrograms();
  renderer_->finishWork();
}

double OffscreenScene::timedFrame() {
  window_->MakeCurrent();
  const double start = processCpuSeconds();
  window_->Render();
  window_->WaitForCompletion();  // software OpenGL works on in its threads after the call has returned
  return processCpuSeconds() - start;
}

void OffscreenScene::setDrawn(bool drawn) {
  renderer_->renderer()->SetDraw(drawn ? 1 : 0);
}

void OffscreenScene::forget() {
  window_->MakeCurrent();
  renderer_.reset();
  renderer_ = std::make_unique<SceneRenderer>(window_);
  renderer_->setSightLines(traceSightLines);
  shown_.reset();
  models_.clear();
  bakedFolder_.clear();
  bakeTargets_.clear();
  cutShort_.clear();
}

}  // namespace boxprobe
