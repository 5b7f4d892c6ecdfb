// See object_outline.h.
#include "filters/vtk/inspect/object_outline.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOutlineGlowPass.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderState.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>

#include <algorithm>

namespace boxprobe {

namespace {

constexpr int kLayersAbove = 3;  ///< over the handles' two, which would be drawn over by it otherwise
constexpr double kColor[3] = {1.0, 0.70, 0.10};
constexpr float kIntensity = 8.0f;

/// VTK 9.1 lets this pass's textures repeat, which gives what an edge of the window cuts an outline at the opposite
/// edge, and sets their filters after the first frame has used them.
class ClampedOutlinePass : public vtkOutlineGlowPass {
 public:
  static ClampedOutlinePass* New() { VTK_STANDARD_NEW_BODY(ClampedOutlinePass); }
  vtkTypeMacro(ClampedOutlinePass, vtkOutlineGlowPass) void Render(const vtkRenderState* state) override {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
    for (vtkTextureObject** texture : {&this->ScenePass, &this->BlurPass1, &this->BlurPass2}) {
      if (*texture == nullptr) {
        *texture = vtkTextureObject::New();
        (*texture)->SetContext(window);
      }
      (*texture)->SetWrapS(vtkTextureObject::ClampToEdge);
      (*texture)->SetWrapT(vtkTextureObject::ClampToEdge);
      (*texture)->SetMinificationFilter(vtkTextureObject::Linear);
      (*texture)->SetMagnificationFilter(vtkTextureObject::Linear);
    }
    this->Superclass::Render(state);
  }
};

}  // namespace

ObjectOutline::~ObjectOutline() {
  if (layer_ != nullptr && window_ != nullptr) window_->RemoveRenderer(layer_);
}

void ObjectOutline::build() {
  layer_ = vtkSmartPointer<vtkRenderer>::New();
  const int layer = scene_->GetLayer() + kLayersAbove;
  window_->SetNumberOfLayers(std::max(window_->GetNumberOfLayers(), layer + 1));
  layer_->SetLayer(layer);
  layer_->InteractiveOff();
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<ClampedOutlinePass> glow;
  glow->SetDelegatePass(steps);
  glow->SetOutlineIntensity(kIntensity);
  layer_->SetPass(glow);
}

void ObjectOutline::place(vtkActor* piece, vtkActor* twin) {
  vtkMatrix4x4* to = twin->GetUserMatrix();
  vtkMatrix4x4* from = piece->GetUserMatrix();
  from != nullptr ? to->DeepCopy(from) : to->Identity();
}

void ObjectOutline::show(const std::vector<vtkActor*>& pieces) {
  if (window_ == nullptr || scene_ == nullptr || (pieces.empty() && twins_.empty())) return;
  if (layer_ == nullptr) build();
  const bool same = pieces.size() == pieces_.size() &&
                    std::equal(pieces.begin(), pieces.end(), pieces_.begin(), [](auto* a, auto& b) {
                      return a == b.actor && a->GetMapper()->GetInputDataObject(0, 0) == b.data;
                    });
  if (same) {
    for (std::size_t i = 0; i < pieces.size(); ++i) place(pieces[i], twins_[i]);
    return;
  }
  pieces_.clear();
  for (const auto& twin : twins_) layer_->RemoveActor(twin);
  twins_.clear();
  for (vtkActor* piece : pieces) {
    auto twin = vtkSmartPointer<vtkActor>::New();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputDataObject(piece->GetMapper()->GetInputDataObject(0, 0));
    mapper->ScalarVisibilityOff();
    twin->SetMapper(mapper);
    vtkNew<vtkMatrix4x4> matrix;  // the piece's own changes when it is moved
    twin->SetUserMatrix(matrix);
    place(piece, twin);
    twin->GetProperty()->LightingOff();
    twin->GetProperty()->SetColor(kColor[0], kColor[1], kColor[2]);
    twin->PickableOff();
    layer_->AddActor(twin);
    twins_.push_back(twin);
    pieces_.push_back({piece, piece->GetMapper()->GetInputDataObject(0, 0)});
  }
  layer_->SetActiveCamera(scene_->GetActiveCamera());  // depths are not compared, but places are the same
  if (twins_.empty()) {
    window_->RemoveRenderer(layer_);
  } else if (!window_->HasRenderer(layer_)) {
    window_->AddRenderer(layer_);
  }
}

void ObjectOutline::release() {
  if (layer_ == nullptr || window_ == nullptr) return;
  show({});
  layer_->ReleaseGraphicsResources(window_);
  layer_ = nullptr;
}

}  // namespace boxprobe
