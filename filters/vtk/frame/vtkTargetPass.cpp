#include "filters/vtk/frame/vtkTargetPass.h"

#include <vtkCamera.h>
#include <vtkLightsPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>

#include <algorithm>
#include <vector>

#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/surface/glass_order.h"

vtkStandardNewMacro(vtkTargetPass);

namespace {

// Translucent surfaces must be drawn after what is behind them: sorted by the centres of their bounds, which is correct
// unless they intersect. Opaque ones keep their order.
std::vector<vtkProp*> backToFront(std::vector<vtkProp*> props, vtkCamera* camera) {
  struct Layer {
    vtkProp* prop;
    double distance;
  };
  std::vector<Layer> layers;
  const double* eye = camera->GetPosition();
  const double* along = camera->GetDirectionOfProjection();
  for (vtkProp* prop : props) {
    double* b = prop->HasTranslucentPolygonalGeometry() != 0 ? prop->GetBounds() : nullptr;
    if (b == nullptr) {
      continue;
    }
    double distance = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      distance += along[axis] * (0.5 * (b[2 * axis] + b[2 * axis + 1]) - eye[axis]);
    }
    layers.push_back({prop, distance});
  }
  if (layers.size() < 2) {
    return props;
  }
  std::stable_sort(layers.begin(), layers.end(),
                   [](const Layer& a, const Layer& b) { return a.distance > b.distance; });
  auto next = layers.begin();
  for (vtkProp*& prop : props) {
    if (prop->HasTranslucentPolygonalGeometry() != 0 && prop->GetBounds() != nullptr) {
      prop = (next++)->prop;
    }
  }
  return props;
}

}  // namespace

vtkTargetPass::vtkTargetPass() {
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  passes->AddItem(translucent);
  this->Content->SetPasses(passes);
}

vtkTargetPass::~vtkTargetPass() = default;

void vtkTargetPass::Render(const vtkRenderState* s) {
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const boxprobe::PassState saved(window);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  state->vtkglViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
  state->vtkglEnable(GL_DEPTH_TEST);
  if (this->Blend) {
    state->vtkglEnable(GL_BLEND);
  } else {
    state->vtkglDisable(GL_BLEND);
  }
  if (this->Clear && this->Empty) {
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearDepth(1.0);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  } else if (this->Clear) {
    renderer->Clear();
  }
  std::vector<vtkProp*> props =
      boxprobe::glassLast(backToFront(this->Props, renderer->GetActiveCamera()), renderer->GetActiveCamera());
  vtkRenderState content(renderer);
  content.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  this->Content->Render(&content);
}
