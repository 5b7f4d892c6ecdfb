// See surfaceless_window.h. Where there is no EGL, VTK's own window draws off the screen.
#include "app/session/surfaceless_window.h"

namespace boxprobe {

vtkSmartPointer<vtkGenericOpenGLRenderWindow> makeSurfacelessWindow(std::string& why, bool) {
  why = "this system has no EGL";
  return nullptr;
}

}  // namespace boxprobe
