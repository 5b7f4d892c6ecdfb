// Settings for one pass, restored when the scope ends, also by an exception. Pass settings are changed only this way.
#pragma once

#include <vtkSmartPointer.h>

#include <functional>

#include "filters/vtk/draw/draw_state.h"

class vtkCamera;

namespace boxprobe {

class PassScope {
 public:
  using Change = std::function<void(PassSettings&)>;

  /// `change` edits the current settings, so scopes can be nested. `state` must outlive the scope.
  PassScope(DrawState& state, const Change& change);
  /// The same for a pass with another camera than the window's: `renderer` draws with `camera` until the scope ends.
  /// VTK uploads a program's lights only if the camera is newer than the last upload, whichever camera that was for,
  /// and renderers share programs; so both are marked as modified: `camera` at the start, the window's at the end.
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
