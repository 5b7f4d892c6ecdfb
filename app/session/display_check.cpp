// See display_check.h. The only file that includes Xlib: its macros (None, Bool, Status) must not reach others.
#include "app/session/display_check.h"

#include <GL/glx.h>
#include <X11/Xlib.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/session/interrupt.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/memory_check.h"
#include "filters/platform/process.h"
#include "filters/platform/terminal.h"

namespace boxprobe {

namespace {

/// Mesa says on stderr what it could not load, and cannot be kept from it; our own line says what to do.
class QuietStderr {
 public:
  QuietStderr() {
    if (errors_.kept() < 0) return;
    sayOfSignalsTo(errors_.kept());
    errors_.silence();
  }
  ~QuietStderr() {
    errors_.restore();
    sayOfSignalsTo(kStandardError);
  }
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;

 private:
  KeptErrors errors_;
};

int ignoreXError(Display*, XErrorEvent*) {
  return 0;
}

template <typename Function>
Function glxFunction(const char* name) {
  return reinterpret_cast<Function>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name)));
}

/// Empty, or why VTK could not draw there: it aborts, or dumps its shaders. A context is made as VTK makes one.
std::string missingFromGlx(Display* display) {
  const QuietStderr quiet;
  const int wanted[] = {GLX_DRAWABLE_TYPE,
                        GLX_WINDOW_BIT,
                        GLX_RENDER_TYPE,
                        GLX_RGBA_BIT,
                        GLX_RED_SIZE,
                        1,
                        GLX_GREEN_SIZE,
                        1,
                        GLX_BLUE_SIZE,
                        1,
                        GLX_DEPTH_SIZE,
                        1,
                        GLX_DOUBLEBUFFER,
                        1,
                        0};
  int count = 0;
  GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  if (configs == nullptr || count == 0) return "it offers no visual in true colour with a depth buffer";
  const GLXFBConfig config = configs[0];
  XFree(configs);
  const auto create = glxFunction<PFNGLXCREATECONTEXTATTRIBSARBPROC>("glXCreateContextAttribsARB");
  const int version[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 2, 0};
  const auto handler = XSetErrorHandler(ignoreXError);
  const GLXContext context = create == nullptr ? nullptr : create(display, config, nullptr, 1, version);
  std::string missing;
  if (context == nullptr) {
    missing = "it offers no OpenGL 3.2; install libgl1-mesa-dri or your card's driver";
  } else if (glXMakeContextCurrent(display, 0, 0, context) != 0) {
    const auto getString = glxFunction<const GLubyte* (*)(GLenum)>("glGetString");
    const GLubyte* text = getString == nullptr ? nullptr : getString(GL_VERSION);
    int major = 3, minor = 2;
    if (text != nullptr) std::sscanf(reinterpret_cast<const char*>(text), "%d.%d", &major, &minor);
    if (10 * major + minor < 32) {
      missing = "its driver has OpenGL " + std::to_string(major) + "." + std::to_string(minor) + ", and 3.2 is needed";
    }
    glXMakeContextCurrent(display, 0, 0, nullptr);
  }
  if (context != nullptr) glXDestroyContext(display, context);
  XSync(display, 0);
  XSetErrorHandler(handler);
  return missing;
}

/// The window draws by X. Where Qt would take another of its platforms, or look for one that is not installed, X it is.
void preferX() {
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  if (platform == nullptr || std::string(platform).rfind("wayland", 0) == 0)
    setEnvironment("QT_QPA_PLATFORM", "xcb", true);
}

}  // namespace

bool displayIsNamed() {
  const char* name = std::getenv("DISPLAY");
  return name != nullptr && *name != '\0';
}

void requireDisplay(const std::string& command) {
  static bool found = false;  // asked once: each asking keeps a connection, see below
  if (found) return;
  const std::string advice =
      ": run `xvfb-run -a " + command + " ...`, which draws without a screen, or start it from a desktop";
  const char* name = std::getenv("DISPLAY");
  if (!displayIsNamed()) {
    const bool wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
    throw InputError("no display (DISPLAY is not set" + std::string(wayland ? "; on Wayland, install xwayland)" : ")") +
                     advice);
  }
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
  const std::string missing = missingFromGlx(display);
  if (!missing.empty()) {
    XCloseDisplay(display);
    requireMemory();
    throw WorkError("no OpenGL on display '" + std::string(name) + "': " + missing);
  }
  preferX();
  // Left open to the end of the process: an X server starts again when its last client leaves (xvfb-run's does), and
  // turns away whoever connects in that moment, which would be VTK.
  found = true;
}

}  // namespace boxprobe
