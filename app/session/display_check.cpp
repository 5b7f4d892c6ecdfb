// See display_check.h. The only file that includes Xlib: its macros (None, Bool, Status) must not reach others.
#include "app/session/display_check.h"

#include <X11/Xlib.h>

#include <cstdlib>

#include "filters/core/base/errors.h"

namespace boxprobe {

void requireDisplay(const std::string& command) {
  static bool found = false;  // asked once: each asking keeps a connection, see below
  if (found) return;
  const std::string advice =
      ": run `xvfb-run -a " + command + " ...`, which draws without a screen, or start it from a desktop";
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') throw InputError("no display (DISPLAY is not set)" + advice);
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr)
    throw InputError("no display (the X server '" + std::string(name) + "' cannot be reached)" + advice);
  int opcode = 0;
  int event = 0;
  int error = 0;
  if (XQueryExtension(display, "GLX", &opcode, &event, &error) == 0) {
    XCloseDisplay(display);
    throw InputError("no OpenGL on display '" + std::string(name) + "' (it has no GLX)" + advice);
  }
  // Left open to the end of the process: an X server starts again when its last client leaves (xvfb-run's does), and
  // turns away whoever connects in that moment, which would be VTK.
  found = true;
}

}  // namespace boxprobe
