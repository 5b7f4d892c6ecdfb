// A render window that never shows, for sub-commands and lessons. Debian's VTK draws through GLX alone, so an X display
// is needed all the same.
#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkOpenGLRenderWindow;

namespace boxprobe {

struct OffscreenSettings {
  std::string command;  ///< what the user called, for the advice where there is no display: "boxprobe render"
  int width = 16, height = 16;
  int samplesPerPixel = 1;   ///< brought down to what the driver offers; see GetMultiSamples()
  bool quiet = false;        ///< VTK's warnings are not printed
  bool printErrors = false;  ///< VTK's errors are printed as they come, for a program that goes on
};

/// Asks for the display, takes over VTK's messages, then makes the window: initialised, its context current. Throws
/// InputError without a display, WorkError where the driver refuses.
vtkSmartPointer<vtkOpenGLRenderWindow> openOffscreenWindow(const OffscreenSettings& settings);

}  // namespace boxprobe
