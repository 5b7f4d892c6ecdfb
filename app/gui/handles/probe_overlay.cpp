// See probe_overlay.h.
#include "app/gui/handles/probe_overlay.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace boxprobe {

namespace {

/// Lines are drawn this much nearer to the viewer than they are. A probe's box lies on the walls or a little behind
/// them and would else flicker or vanish where it matters most; 3 % of the distance passes over such gaps and still
/// leaves a pillar in front of a line in front.
constexpr double kPull = 0.97;

vtkSmartPointer<vtkRenderer> addLayer(vtkRenderWindow* window, int layer) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  window->SetNumberOfLayers(layer + 1);
  renderer->SetLayer(layer);
  renderer->InteractiveOff();
  window->AddRenderer(renderer);
  return renderer;
}

}  // namespace

ProbeOverlay::ProbeOverlay(vtkRenderWindow* window, vtkRenderer* sceneRenderer)
    : window_(window),
      scene_(sceneRenderer),
      solidLayer_(addLayer(window, 1)),
      onTopLayer_(addLayer(window, 2)),
      solid_(solidLayer_, false),
      faint_(onTopLayer_, true),
      handles_(onTopLayer_) {
  solidLayer_->PreserveDepthBufferOn();
}

ProbeOverlay::~ProbeOverlay() {
  window_->RemoveRenderer(solidLayer_);
  window_->RemoveRenderer(onTopLayer_);
}

void ProbeOverlay::update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                          const std::vector<std::size_t>& together, std::optional<Handle> highlighted,
                          HandleMode mode) {
  solid_.update(probes, selected, together, mode);
  faint_.update(probes, selected, together, mode);
  handles_.update(probes, selected, together, highlighted, mode);
  setVisible(visible_);
}

void ProbeOverlay::setGhosts(const std::vector<Probe>& ghosts) {
  solid_.setGhosts(ghosts);
  faint_.setGhosts(ghosts);
  setVisible(visible_);
}

void ProbeOverlay::setDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld) {
  solid_.setDrop(endsWorld);
  faint_.setDrop(endsWorld);
  setVisible(visible_);
}

void ProbeOverlay::setVisible(bool visible) {
  visible_ = visible;
  solid_.setVisible(visible);
  faint_.setVisible(visible);
  handles_.setVisible(visible);
}

void ProbeOverlay::setSuspended(bool suspended) {
  solidLayer_->SetDraw(suspended ? 0 : 1);
  onTopLayer_->SetDraw(suspended ? 0 : 1);
}

void ProbeOverlay::follow(const ViewProjection& view) {
  solid_.pullTowards(view.eyeWorld(), kPull);
  handles_.fit(view);
  // The same camera, or else the depths of the two pictures could not be compared.
  vtkCamera* camera = scene_->GetActiveCamera();
  if (solidLayer_->GetActiveCamera() != camera) solidLayer_->SetActiveCamera(camera);
  // A copy here: boxes may reach far beyond the scene, whose depth range would cut them off.
  vtkNew<vtkCamera> copy;
  copy->DeepCopy(camera);
  onTopLayer_->SetActiveCamera(copy);
  onTopLayer_->ResetCameraClippingRange();
}

}  // namespace boxprobe
