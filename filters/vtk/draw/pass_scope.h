// One pass with settings of its own: what it changes is put back when the scope ends, by an exception too. The only way
// to change how a pass draws. Used by captures, mirrors, averaged frames and explanations; knows none of them.
#pragma once

#include <vtkSmartPointer.h>

#include <functional>

#include "filters/vtk/draw/draw_state.h"

class vtkCamera;

namespace boxprobe {

class PassScope {
 public:
  using Change = std::function<void(PassSettings&)>;

  /// `change` edits the settings as they are, so that scopes may lie within each other. `state` must outlive the scope.
  PassScope(DrawState& state, const Change& change);
  /// The same for a pass through another camera than the window's: `renderer` draws through `camera` until the scope
  /// ends. VTK uploads a program's lighting only when the camera is newer than the last upload, whichever camera that
  /// was for, and renderers share programs; so both are marked as changed: `camera` now, the window's in the end.
  PassScope(DrawState& state, vtkRenderer* renderer, vtkCamera* camera, const Change& change);
  ~PassScope();
  PassScope(const PassScope&) = delete;
  PassScope& operator=(const PassScope&) = delete;

 private:
  DrawState& state_;
  PassSettings before_;
  vtkSmartPointer<vtkRenderer> renderer_;  ///< null: the pass keeps the camera
  vtkSmartPointer<vtkCamera> cameraBefore_;
};

}  // namespace boxprobe
