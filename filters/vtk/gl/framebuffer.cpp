#include "filters/vtk/gl/framebuffer.h"

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

// Saves a binding and restores it. VTK tracks draw and read bindings separately.
class Binding {
 public:
  explicit Binding(GLuint framebuffer) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  }
  ~Binding() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  }
  Binding(const Binding&) = delete;
  Binding& operator=(const Binding&) = delete;

 private:
  GLint draw_ = 0, read_ = 0;
};

void attachTo(GLenum point, const FramebufferImage& image) {
  if (image.kind == FramebufferImage::Kind::RenderBuffer) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, image.handle);
  } else {
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, image.target, image.handle, image.level);
  }
}

GLenum colorPoint(std::size_t i) {
  return GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
}

}  // namespace

void Framebuffer::attach(const std::vector<FramebufferImage>& colors, const FramebufferImage& depth,
                         const Refusal& refusal) {
  if (handle_ == 0) glGenFramebuffers(1, &handle_);
  GLenum status = GL_FRAMEBUFFER_COMPLETE;
  {
    const Binding bound(handle_);
    std::vector<GLenum> points;
    for (std::size_t i = 0; i < colors.size(); ++i) {
      attachTo(colorPoint(i), colors[i]);
      points.push_back(colorPoint(i));
    }
    for (std::size_t i = colors.size(); i < colors_; ++i) attachTo(colorPoint(i), {});
    colors_ = colors.size();
    attachTo(GL_DEPTH_ATTACHMENT, depth);
    if (points.empty()) points.push_back(GL_NONE);
    glDrawBuffers(static_cast<GLsizei>(points.size()), points.data());
    glReadBuffer(points.front());
    status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  }
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  release();
  throw WorkError(refusal(status));
}

void Framebuffer::release() {
  if (handle_ != 0) glDeleteFramebuffers(1, &handle_);
  handle_ = 0;
  colors_ = 0;
}

Framebuffer::Refusal floatRefusal(const char* what) {
  return [what](GLenum status) {
    return std::string("OpenGL refuses the framebuffer for ") + what + " (status " + std::to_string(status) +
           "); a driver with float render targets is needed";
  };
}

GLuint makeTargetTexture(int width, int height, GLenum internalFormat, GLenum format) {
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  GLuint handle = 0;
  glGenTextures(1, &handle);
  glBindTexture(GL_TEXTURE_2D, handle);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), width, height, 0, format, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  return handle;
}

GLuint makeRenderBuffer(int width, int height, int samples, GLenum internalFormat) {
  GLuint handle = 0;
  glGenRenderbuffers(1, &handle);
  glBindRenderbuffer(GL_RENDERBUFFER, handle);
  if (samples > 1) {
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internalFormat, width, height);
  } else {
    glRenderbufferStorage(GL_RENDERBUFFER, internalFormat, width, height);
  }
  return handle;
}

}  // namespace boxprobe
