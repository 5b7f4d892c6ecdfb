// See offscreen_window.h.
#include "app/session/offscreen_window.h"

#include <vtkOpenGLRenderWindow.h>
#if __has_include(<vtkOSOpenGLRenderWindow.h>)
#include <vtkOSOpenGLRenderWindow.h>
#endif
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "app/session/display_check.h"
#include "app/session/surfaceless_window.h"
#include "app/session/vtk_messages.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/memory_check.h"
#include "filters/platform/process.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

namespace {

vtkSmartPointer<vtkOpenGLRenderWindow> windowOnDisplay(const std::string& command) {
  requireDisplay(command);
  const auto any = vtkSmartPointer<vtkRenderWindow>::New();
  vtkSmartPointer<vtkOpenGLRenderWindow> window = vtkOpenGLRenderWindow::SafeDownCast(any);
  if (!window) throw WorkError("this VTK has no OpenGL render window: build it with the RenderingOpenGL2 module");
  return window;
}

vtkSmartPointer<vtkOpenGLRenderWindow> osmesaWindow() {
#if __has_include(<vtkOSOpenGLRenderWindow.h>)
  return vtkSmartPointer<vtkOSOpenGLRenderWindow>::New();
#else
  throw InputError("--offscreen osmesa: this VTK was built without OSMesa; use --offscreen egl");
#endif
}

vtkSmartPointer<vtkOpenGLRenderWindow> windowFor(const OffscreenSettings& settings) {
  Offscreen offscreen = settings.offscreen;
  if (offscreen == Offscreen::Automatic) offscreen = displayIsNamed() ? Offscreen::X : Offscreen::Egl;
  if (offscreen == Offscreen::X) return windowOnDisplay(settings.command);
  if (offscreen == Offscreen::Osmesa) return osmesaWindow();
  std::string why;
  if (const auto window = makeSurfacelessWindow(why)) return window;
  requireMemory();
  if (settings.offscreen == Offscreen::Egl) throw InputError("--offscreen egl: " + why);
  throw InputError("nothing to draw with: DISPLAY is not set, and " + why +
                   "; install libegl-mesa0, or run `xvfb-run -a " + settings.command + " ...`");
}

bool drawsFloats() {
  GLuint texture = 0, target = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 4, 4, 0, GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  GLint before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  glGenFramebuffers(1, &target);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  const bool complete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
  glDeleteFramebuffers(1, &target);
  glDeleteTextures(1, &texture);
  return complete;
}

}  // namespace

vtkSmartPointer<vtkOpenGLRenderWindow> openOffscreenWindow(const OffscreenSettings& settings) {
  if (!settings.beside) installVtkMessages(settings.quiet, settings.printErrors);
  if (settings.fewFrames && !settings.beside) setEnvironment("GALLIVM_PERF", "nopt", false);
  const std::string toldBefore = firstVtkError();
  vtkSmartPointer<vtkOpenGLRenderWindow> window = windowFor(settings);
  window->SetOffScreenRendering(1);  // draws into a framebuffer of its own, and shows nothing
  window->SetMultiSamples(0);
  window->SetSize(settings.width, settings.height);
  window->Initialize();
  window->MakeCurrent();
  const std::string told = firstVtkError();
  if (!window->IsCurrent() || told != toldBefore) {
    requireMemory();
    throw WorkError("cannot start OpenGL 3.2 here" + (told == toldBefore ? std::string() : ": " + told));
  }
  int major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  const std::string missing = missingFromOpenGl(10 * major + minor, drawsFloats());
  if (!missing.empty()) {
    requireMemory();
    throw WorkError("this OpenGL driver cannot draw probes: " + missing);
  }
  int mostSamples = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &mostSamples);
  const int samples = std::min(settings.samplesPerPixel, mostSamples);
  window->SetMultiSamples(samples > 1 ? samples : 0);
  return window;
}

}  // namespace boxprobe
