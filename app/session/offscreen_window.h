// A render window that never shows, for sub-commands. Debian's VTK draws through GLX alone, so an X display is needed
// all the same: call requireDisplay() first.
#pragma once

#include <vtkSmartPointer.h>

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Initialised, its context current. Throws WorkError where the driver refuses. `samplesPerPixel` is brought down to
/// what the driver offers; see GetMultiSamples().
vtkSmartPointer<vtkOpenGLRenderWindow> makeOffscreenWindow(int width, int height, int samplesPerPixel);

}  // namespace boxprobe
