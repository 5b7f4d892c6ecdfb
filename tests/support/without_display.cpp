// Programs of tests that draw, on a machine without an X server: where DISPLAY is not set, VTK's windows are made on
// EGL, as the program's own are. So the packed programs of a test run on a bare machine with a graphics card.
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkVersion.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/session/surfaceless_window.h"

namespace boxprobe {
namespace {

vtkObject* newSurfacelessWindow() {
  std::string why;
  const auto window = makeSurfacelessWindow(why);
  if (!window) {
    std::fprintf(stderr, "nothing to draw with: DISPLAY is not set, and %s\n", why.c_str());
    std::exit(1);
  }
  window->Register(nullptr);  // the caller's reference
  return window;
}

class SurfacelessFactory : public vtkObjectFactory {
 public:
  static SurfacelessFactory* New() {
    auto* factory = new SurfacelessFactory;
    factory->InitializeObjectBase();
    return factory;
  }
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "render windows on EGL"; }

 protected:
  SurfacelessFactory() {
    RegisterOverride("vtkRenderWindow", "vtkSurfacelessWindow", "without a display", 1, newSurfacelessWindow);
  }
};

const bool registered = [] {
  const char* display = std::getenv("DISPLAY");
  if (display != nullptr && *display != '\0') return false;
  vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow");  // the windows on X
  auto* factory = SurfacelessFactory::New();
  vtkObjectFactory::RegisterFactory(factory);
  factory->Delete();
  return true;
}();

}  // namespace
}  // namespace boxprobe
