#include "filters/vtk/frame/behind_frame.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <algorithm>

#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

namespace {

GLuint makeTexture(int width, int height, GLint format, GLenum channels, bool levels) {
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  int level = 0;
  for (;; ++level) {
    const int w = std::max(width >> level, 1), h = std::max(height >> level, 1);
    glTexImage2D(GL_TEXTURE_2D, level, format, w, h, 0, channels, GL_FLOAT, nullptr);
    if (!levels || (w == 1 && h == 1)) break;
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  // Depths of two surfaces must not be averaged.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, levels ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, levels ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  return texture;
}

}  // namespace

BehindFrame::BehindFrame(Counters* counters) : copy_({"shared/finite.glsl", "gpu/behind_frame.glsl"}, counters) {}

void BehindFrame::allocate(int width, int height) {
  if (framebuffer_.made() && width == picture_.width && height == picture_.height) return;
  releaseTextures();
  picture_.width = width;
  picture_.height = height;
  picture_.color = makeTexture(width, height, GL_RGBA16F, GL_RGBA, true);
  picture_.depth = makeTexture(width, height, GL_R32F, GL_RED, false);
  framebuffer_.attach({textureImage(picture_.color), textureImage(picture_.depth)}, {},
                      floatRefusal("what is seen through glass"));
}

BehindPicture BehindFrame::take(vtkOpenGLRenderWindow* window, const FrameTarget& frame) {
  frame.resolve(window);
  allocate(frame.width(), frame.height());
  vtkOpenGLState* state = window->GetState();
  {
    const PassState saved(window);
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.handle());
    state->vtkglViewport(0, 0, frame.width(), frame.height());
    const BoundTexture color(window, GL_TEXTURE_2D, frame.texture(0)), depth(window, GL_TEXTURE_2D, frame.depth());
    copy_.draw(window, [&](vtkShaderProgram* program) {
      program->SetUniformi("bpColor", color.unit());
      program->SetUniformi("bpDepth", depth.unit());
    });
  }
  const BoundTexture levels(window, GL_TEXTURE_2D, picture_.color);
  glGenerateMipmap(GL_TEXTURE_2D);
  return picture_;
}

void BehindFrame::releaseTextures() {
  framebuffer_.release();
  for (GLuint texture : {picture_.color, picture_.depth}) {
    if (texture != 0) glDeleteTextures(1, &texture);
  }
  picture_ = {};
}

void BehindFrame::release() {
  releaseTextures();
  copy_.release();
}

}  // namespace boxprobe
