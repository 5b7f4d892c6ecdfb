// See diffuse_truth.h.
#include "app/gui/explain/diffuse_truth.h"

#include "filters/reference/path/reference_path.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr int kRestMilliseconds = 300;

}  // namespace

DiffuseTruth::DiffuseTruth(SceneRenderer& renderer, QObject* parent) : QObject(parent), renderer_(renderer) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMilliseconds);
  connect(&rest_, &QTimer::timeout, this, &DiffuseTruth::start);
  connect(&trace_, &ReferenceTrace::failed, this, &DiffuseTruth::failed);
  connect(&trace_, &ReferenceTrace::traced, this,
          [this](const QImage&, double share, const std::shared_ptr<const ReferencePicture>& light) {
            if (!light || outdated_) return;
            share_ = share;
            renderer_.setDiffuseTruth(diffuseTruthImage(*light));
            emit pictureChanged();
          });
}

void DiffuseTruth::setWanted(bool wanted) {
  if (wanted == wanted_) return;
  wanted_ = wanted;
  forget();
}

void DiffuseTruth::setModels(const std::vector<std::shared_ptr<const Model>>& models) {
  models_ = models;
  forget();
}

void DiffuseTruth::sceneChanged() {
  forget();
}

void DiffuseTruth::update(const Scene& scene, const QSize& size) {
  if (!wanted_) return;
  const Camera camera = renderer_.currentCamera();
  if (!outdated_ && camera == camera_ && size == size_) return;
  if (!outdated_) forget();
  if (outdated_ && rest_.isActive() && camera == camera_ && size == size_) return;
  outdated_ = true;
  scene_ = scene;
  camera_ = camera;
  size_ = size;
  rest_.start();
}

void DiffuseTruth::forget() {
  trace_.end();
  rest_.stop();
  outdated_ = true;
  share_ = 0.0;
  renderer_.setDiffuseTruth({});
}

void DiffuseTruth::start() {
  if (!wanted_ || size_.isEmpty() || scene_.models.empty()) return;
  outdated_ = false;
  trace_.start(scene_, models_, camera_, size_, TracedLight::Diffuse);
}

}  // namespace boxprobe
