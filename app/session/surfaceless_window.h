// A render window on EGL, for machines without a window system: Mesa's surfaceless platform, else EGL's default
// display, else the first device of EGL's that draws. VTK has such a window only where it was built with EGL, and
// Debian's 9.1 and 9.3 were not.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace boxprobe {

/// Its context is made; Initialize() starts VTK's side. Null where there is none: `why` then says so in a few words.
/// `devicesAlone`: only on what EGL_EXT_platform_device lists, as on drivers that have nothing else.
vtkSmartPointer<vtkGenericOpenGLRenderWindow> makeSurfacelessWindow(std::string& why, bool devicesAlone = false);

}  // namespace boxprobe
