#include "filters/vtk/draw/pass_scope.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace boxprobe {

namespace {

// Requesting a missing camera would create one, placed by the renderer's contents.
vtkCamera* cameraOf(vtkRenderer* renderer) {
  return renderer != nullptr && renderer->IsActiveCameraCreated() != 0 ? renderer->GetActiveCamera() : nullptr;
}

}  // namespace

PassScope::PassScope(DrawState& state, const Change& change) : state_(state), before_(state.pass_) {
  PassSettings changed = before_;
  change(changed);
  state_.pass_ = changed;
}

PassScope::PassScope(DrawState& state, vtkRenderer* renderer, vtkCamera* camera, const Change& change)
    : PassScope(state, change) {
  renderer_ = renderer;
  cameraBefore_ = cameraOf(renderer);
  renderer->SetActiveCamera(camera);
  camera->Modified();
}

PassScope::~PassScope() {
  state_.pass_ = before_;
  if (!renderer_) return;
  renderer_->SetActiveCamera(cameraBefore_);
  if (vtkCamera* shown = cameraOf(state_.shown)) shown->Modified();
}

}  // namespace boxprobe
