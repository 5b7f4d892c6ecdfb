// See offscreen_window.h.
#include "app/session/offscreen_window.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>
#include <vtk_glew.h>

#include <algorithm>
#include <string>

#include "app/session/display_check.h"
#include "app/session/vtk_messages.h"
#include "filters/core/base/errors.h"

namespace boxprobe {

vtkSmartPointer<vtkOpenGLRenderWindow> openOffscreenWindow(const OffscreenSettings& settings) {
  requireDisplay(settings.command);
  installVtkMessages(settings.quiet, settings.printErrors);
  const auto any = vtkSmartPointer<vtkRenderWindow>::New();
  vtkSmartPointer<vtkOpenGLRenderWindow> window = vtkOpenGLRenderWindow::SafeDownCast(any);
  if (!window) throw WorkError("this VTK has no OpenGL render window: build it with the RenderingOpenGL2 module");
  window->SetOffScreenRendering(1);  // draws into a framebuffer of its own, and shows nothing
  window->SetMultiSamples(0);
  window->SetSize(settings.width, settings.height);
  window->Initialize();
  window->MakeCurrent();
  if (!window->IsCurrent() || !firstVtkError().empty()) {
    throw WorkError("cannot start OpenGL 3.2 on this display" +
                    (firstVtkError().empty() ? std::string() : ": " + firstVtkError()));
  }
  int mostSamples = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &mostSamples);
  const int samples = std::min(settings.samplesPerPixel, mostSamples);
  window->SetMultiSamples(samples > 1 ? samples : 0);
  return window;
}

}  // namespace boxprobe
