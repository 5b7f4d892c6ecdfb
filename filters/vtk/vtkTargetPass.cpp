#include "filters/vtk/vtkTargetPass.h"

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

#include "filters/vtk/gl_objects.h"

vtkStandardNewMacro(vtkTargetPass);

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
  if (this->Clear) {
    renderer->Clear();
  }
  vtkRenderState content(renderer);
  content.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
  this->Content->Render(&content);
}
