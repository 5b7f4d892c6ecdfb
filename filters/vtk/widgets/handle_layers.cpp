#include "filters/vtk/widgets/handle_layers.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace boxprobe {

namespace {

/// Lines are drawn this much nearer to the viewer. A probe's box lies on the walls or slightly behind them, where it
/// would flicker or be hidden; 3 % of the distance bridges such gaps, and a pillar in front still hides a line.
constexpr double kPull = 0.97;

constexpr double kBesidePointer = 22.0;  ///< logical pixels from the pointer to the readout
constexpr int kReadoutPoints = 13;

vtkSmartPointer<vtkRenderer> addLayer(vtkRenderWindow* window, vtkRenderer* scene, int above) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  const int layer = scene->GetLayer() + above;
  window->SetNumberOfLayers(std::max(window->GetNumberOfLayers(), layer + 1));
  renderer->SetLayer(layer);
  renderer->InteractiveOff();
  window->AddRenderer(renderer);
  return renderer;
}

}  // namespace

HandleLayers::HandleLayers(vtkRenderWindow* window, vtkRenderer* scene)
    : window_(window),
      scene_(scene),
      solidLayer_(addLayer(window, scene, 1)),
      onTopLayer_(addLayer(window, scene, 2)),
      solid_(solidLayer_, false),
      faint_(onTopLayer_, true),
      handles_(onTopLayer_) {
  solidLayer_->PreserveDepthBufferOn();
  drawing_->SetClientData(this);
  drawing_->SetCallback([](vtkObject* layer, unsigned long, void* self, void*) {
    static_cast<HandleLayers*>(self)->takeCamera(vtkRenderer::SafeDownCast(layer));
  });
  for (vtkRenderer* layer : {solidLayer_.Get(), onTopLayer_.Get()}) {
    layer->AddObserver(vtkCommand::StartEvent, drawing_);
  }
}

HandleLayers::~HandleLayers() {
  for (vtkRenderer* layer : {solidLayer_.Get(), onTopLayer_.Get()}) layer->RemoveObserver(drawing_);
  if (window_ == nullptr) return;
  window_->RemoveRenderer(solidLayer_);
  window_->RemoveRenderer(onTopLayer_);
}

vtkRenderWindow* HandleLayers::window() const {
  return window_;
}

void HandleLayers::setLook(const HandleColors& colors, double size) {
  solid_.setColors(colors);
  faint_.setColors(colors);
  handles_.setLook(colors, size);
}

void HandleLayers::update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                          const std::vector<std::size_t>& together, std::optional<Handle> highlighted,
                          HandleMode mode) {
  solid_.update(probes, selected, together, mode);
  faint_.update(probes, selected, together, mode);
  handles_.update(probes, selected, together, highlighted, mode);
}

void HandleLayers::setGhosts(const std::vector<Probe>& ghosts) {
  solid_.setGhosts(ghosts);
  faint_.setGhosts(ghosts);
}

void HandleLayers::setDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld) {
  solid_.setDrop(endsWorld);
  faint_.setDrop(endsWorld);
}

void HandleLayers::setReadout(const std::string& text, const glm::dvec2& pixel, const glm::dvec2& viewPixels) {
  if (text.empty() && !readout_) return;
  if (!readout_) {
    readout_ = vtkSmartPointer<vtkTextActor>::New();
    readout_->PickableOff();
    vtkTextProperty* look = readout_->GetTextProperty();
    const HandleColors colors;
    look->SetFontSize(kReadoutPoints);
    look->SetColor(colors.idle.x, colors.idle.y, colors.idle.z);
    look->SetBackgroundColor(colors.halo.x, colors.halo.y, colors.halo.z);
    look->SetBackgroundOpacity(0.8);
    onTopLayer_->AddViewProp(readout_);
  }
  readout_->SetVisibility(text.empty() ? 0 : 1);
  if (text.empty()) return;
  readout_->SetInput(text.c_str());
  // On the side of the pointer with more room.
  const bool left = pixel.x > 0.5 * viewPixels.x, above = pixel.y > 0.5 * viewPixels.y;
  vtkTextProperty* look = readout_->GetTextProperty();
  left ? look->SetJustificationToRight() : look->SetJustificationToLeft();
  above ? look->SetVerticalJustificationToBottom() : look->SetVerticalJustificationToTop();
  readout_->SetPosition(pixelScale_ * (pixel.x + (left ? -kBesidePointer : kBesidePointer)),
                        pixelScale_ * (viewPixels.y - pixel.y + (above ? kBesidePointer : -kBesidePointer)));
}

void HandleLayers::setDrawn(bool drawn) {
  solidLayer_->SetDraw(drawn ? 1 : 0);
  onTopLayer_->SetDraw(drawn ? 1 : 0);
}

void HandleLayers::follow(const ViewProjection& view, double pixelScale) {
  if (scene_ == nullptr) return;
  solid_.pullTowards(view.eyeWorld(), kPull);
  handles_.fit(view);
  if (pixelScale != pixelScale_) {
    pixelScale_ = pixelScale;
    solid_.setPixelScale(pixelScale);
    faint_.setPixelScale(pixelScale);
    handles_.setPixelScale(pixelScale);
  }
  for (vtkRenderer* layer : {solidLayer_.Get(), onTopLayer_.Get()}) layer->SetViewport(scene_->GetViewport());
}

// The same as for the scene, so that depths of the two pictures can be compared. The layers keep their camera objects,
// because vtkWindowToImageFilter exchanges those of all renderers while it draws.
void HandleLayers::takeCamera(vtkRenderer* layer) {
  if (scene_ == nullptr) return;
  layer->GetActiveCamera()->DeepCopy(scene_->GetActiveCamera());
  // Boxes may extend far beyond the scene, whose depth range would clip them.
  if (layer == onTopLayer_) layer->ResetCameraClippingRange();
}

}  // namespace boxprobe
