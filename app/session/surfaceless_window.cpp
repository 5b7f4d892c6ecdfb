// See surfaceless_window.h. The only file that includes EGL.
#include "app/session/surfaceless_window.h"

#include <vtkObjectFactory.h>

#include "filters/platform/process.h"
#include "filters/vtk/gl/opengl.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <vector>

namespace {

// Owns a context and a surface of one pixel: all drawing goes into framebuffers of VTK's or ours.
class vtkSurfacelessWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static vtkSurfacelessWindow* New();
  vtkTypeMacro(vtkSurfacelessWindow, vtkGenericOpenGLRenderWindow)

      // Empty, or what EGL does not offer.
      std::string Open(bool devicesAlone);

  void Initialize() override {
    this->MakeCurrent();
    if (!this->Initialized) {
      this->OpenGLInit();
    }
  }
  void MakeCurrent() override {
    if (!this->IsCurrent()) {
      eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Context);
    }
  }
  bool IsCurrent() override { return this->Context != EGL_NO_CONTEXT && eglGetCurrentContext() == this->Context; }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;
  // The context is this window's alone: its state is kept from frame to frame, as on an X display, and not given back.
  void OpenGLInit() override { this->vtkOpenGLRenderWindow::OpenGLInit(); }
  void Render() override { this->vtkOpenGLRenderWindow::Render(); }

 protected:
  vtkSurfacelessWindow() { this->SetFrameBlitModeToNoBlit(); }
  ~vtkSurfacelessWindow() override;

 private:
  std::string OpenOn(EGLDisplay display);
  void Close();

  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLContext Context = EGL_NO_CONTEXT;
  EGLSurface Surface = EGL_NO_SURFACE;
};

vtkStandardNewMacro(vtkSurfacelessWindow);

// Whose displays may have a context, the likeliest first. None of them is started yet.
std::vector<EGLDisplay> displays(bool devicesAlone) {
  const char* offered = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const std::string extensions = offered != nullptr ? offered : "";
  const auto has = [&extensions](const char* name) { return extensions.find(name) != std::string::npos; };
  const auto getPlatform =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  std::vector<EGLDisplay> found;
  if (!devicesAlone) {
    if (getPlatform != nullptr && has("EGL_MESA_platform_surfaceless")) {
      found.push_back(getPlatform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    found.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  }
  // Drivers of cards that know no surfaceless platform, and whose default display asks for a window system.
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  if (getPlatform != nullptr && queryDevices != nullptr && has("EGL_EXT_platform_device")) {
    EGLint count = 0;
    if (queryDevices(0, nullptr, &count) != EGL_TRUE) count = 0;
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (queryDevices(count, devices.data(), &count) != EGL_TRUE) count = 0;
    devices.resize(static_cast<std::size_t>(count));
    for (EGLDeviceEXT device : devices) found.push_back(getPlatform(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
  }
  found.erase(std::remove(found.begin(), found.end(), EGL_NO_DISPLAY), found.end());
  return found;
}

std::string vtkSurfacelessWindow::Open(bool devicesAlone) {
  boxprobe::setEnvironment("EGL_LOG_LEVEL", "fatal", false);  // lines of its own about drivers; ours follows
  std::string why = "EGL has no display here";
  for (EGLDisplay display : displays(devicesAlone)) {
    if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) continue;
    why = this->OpenOn(display);
    if (why.empty()) break;
    this->Close();
  }
  return why;
}

std::string vtkSurfacelessWindow::OpenOn(EGLDisplay display) {
  this->Display = display;
  // VTK takes the near plane by how many bits of depth the surface has.
  const EGLint wanted[] = {
      EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_DEPTH_SIZE, 24,
      EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE ||
      eglChooseConfig(this->Display, wanted, &config, 1, &configs) != EGL_TRUE || configs == 0) {
    return "EGL offers no desktop OpenGL";
  }
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                            3,
                            EGL_CONTEXT_MINOR_VERSION_KHR,
                            2,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                            EGL_NONE};
  const EGLint onePixel[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
  this->Context = eglCreateContext(this->Display, config, EGL_NO_CONTEXT, version);
  if (this->Context == EGL_NO_CONTEXT) return "EGL offers no OpenGL 3.2";
  this->Surface = eglCreatePbufferSurface(this->Display, config, onePixel);
  this->MakeCurrent();
  return this->IsCurrent() ? "" : "EGL's context cannot be used";
}

void vtkSurfacelessWindow::OpenGLInitContext() {
#ifdef GLEW_OK
  // GLEW has loaded all of OpenGL when it finds no GLX, and calls that an error.
  if (!this->Initialized) {
    const GLenum result = glewInit();
    this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    this->Initialized = this->GlewInitValid;
    GLfloat widths[2] = {1.0f, 1.0f};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
    this->MaximumHardwareLineWidth = widths[1];
  }
#else
  this->SetOpenGLSymbolLoader([](void*, const char* name) { return eglGetProcAddress(name); }, nullptr);
#endif
  this->Superclass::OpenGLInitContext();
}

vtkSurfacelessWindow::~vtkSurfacelessWindow() {
  this->MakeCurrent();
  this->Finalize();
  this->Close();
}

// The display stays: other windows have the same.
void vtkSurfacelessWindow::Close() {
  if (this->Display == EGL_NO_DISPLAY) return;
  eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (this->Surface != EGL_NO_SURFACE) eglDestroySurface(this->Display, this->Surface);
  if (this->Context != EGL_NO_CONTEXT) eglDestroyContext(this->Display, this->Context);
  this->Surface = EGL_NO_SURFACE;
  this->Context = EGL_NO_CONTEXT;
}

}  // namespace

namespace boxprobe {

vtkSmartPointer<vtkGenericOpenGLRenderWindow> makeSurfacelessWindow(std::string& why, bool devicesAlone) {
  const auto window = vtkSmartPointer<vtkSurfacelessWindow>::New();
  why = window->Open(devicesAlone);
  if (!why.empty()) return nullptr;
  return window;
}

}  // namespace boxprobe
