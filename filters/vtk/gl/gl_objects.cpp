#include "filters/vtk/gl/gl_objects.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureUnitManager.h>

#include "filters/core/base/errors.h"
#include "filters/vtk/gl/map_bytes.h"

namespace boxprobe {

namespace {

GLenum faceTarget(int face) {
  return GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face);
}

// Binding outside of VTK's unit bookkeeping is safe on a unit of our own only while it is put back; creation and
// reading need a binding for a moment, whatever unit is active.
class CubeBinding {
 public:
  explicit CubeBinding(GLuint handle) {
    glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &previous_);
    glBindTexture(GL_TEXTURE_CUBE_MAP, handle);
  }
  ~CubeBinding() { glBindTexture(GL_TEXTURE_CUBE_MAP, static_cast<GLuint>(previous_)); }
  CubeBinding(const CubeBinding&) = delete;
  CubeBinding& operator=(const CubeBinding&) = delete;

 private:
  GLint previous_ = 0;
};

void requireComplete(const char* what) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw WorkError(std::string("OpenGL refuses the framebuffer for ") + what + " (status " + std::to_string(status) +
                    "); a driver with float render targets is needed");
  }
}

}  // namespace

std::string seamlessCubesProblem() {
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  if (glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS) == GL_TRUE) return {};
  while (glGetError() != GL_NO_ERROR) {
  }
  return "this OpenGL driver does not filter across the edges of cube maps (OpenGL 3.2 or ARB_seamless_cube_map is "
         "needed); reflections show seams";
}

void CubeTexture::allocate(int faceSize, int levels, GLenum internalFormat) {
  if (handle_ != 0 && faceSize == faceSize_ && levels == levels_ && internalFormat == internalFormat_) return;
  release();
  faceSize_ = faceSize;
  levels_ = levels;
  internalFormat_ = internalFormat;
  glGenTextures(1, &handle_);
  const CubeBinding binding(handle_);
  const bool distance = internalFormat == GL_R32F, nearest = distance || internalFormat == GL_RGBA32F;
  while (glGetError() != GL_NO_ERROR) {  // errors of others are not this allocation's
  }
  for (int level = 0; level < levels; ++level) {
    for (int face = 0; face < 6; ++face) {
      glTexImage2D(faceTarget(face), level, static_cast<GLint>(internalFormat), faceSize >> level, faceSize >> level, 0,
                   distance ? GL_RED : GL_RGBA, GL_FLOAT, nullptr);
    }
  }
  if (glGetError() == GL_OUT_OF_MEMORY) {
    const std::size_t wanted = bytes();
    release();
    throw WorkError("OpenGL has no memory for a cube map of " + std::to_string(faceSize) + " texels a side, " +
                    memoryText(wanted) + "; lower the probes' faceSize");
  }
  // A mean of two distances is a surface that is not there, so distances are not interpolated.
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, nearest ? GL_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, levels - 1);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

void CubeTexture::release() {
  if (handle_ != 0) glDeleteTextures(1, &handle_);
  handle_ = 0;
}

std::size_t CubeTexture::bytes() const {
  std::size_t texels = 0;
  for (int level = 0; level < levels_; ++level) {
    const auto size = static_cast<std::size_t>(faceSize_ >> level);
    texels += 6 * size * size;
  }
  return handle_ == 0 ? 0 : texels * (internalFormat_ == GL_R32F ? 4 : internalFormat_ == GL_RGBA32F ? 16 : 8);
}

std::vector<float> CubeTexture::readFace(int face, int level) const {
  const auto size = static_cast<std::size_t>(faceSize_ >> level);
  std::vector<float> rgba(size * size * 4);
  const CubeBinding binding(handle_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTexImage(faceTarget(face), level, GL_RGBA, GL_FLOAT, rgba.data());
  return rgba;
}

void CubeTexture::writeFace(int face, int level, const std::vector<float>& rgba) {
  const CubeBinding binding(handle_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(faceTarget(face), level, 0, 0, faceSize_ >> level, faceSize_ >> level, GL_RGBA, GL_FLOAT,
                  rgba.data());
}

void FloatTarget::allocate(int width, int height) {
  if (framebuffer_ != 0 && width == width_ && height == height_) return;
  release();
  width_ = width;
  height_ = height;
  GLint previous = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &previous);
  const auto make = [&](GLenum internalFormat, GLenum format) {
    GLuint handle = 0;
    glGenTextures(1, &handle);
    glBindTexture(GL_TEXTURE_2D, handle);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), width, height, 0, format, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return handle;
  };
  color_ = make(GL_RGBA32F, GL_RGBA);
  depth_ = make(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(previous));

  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  requireComplete("float colour");
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
}

void FloatTarget::release() {
  if (framebuffer_ == 0) return;
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &color_);
  glDeleteTextures(1, &depth_);
  framebuffer_ = color_ = depth_ = 0;
}

void CubeFramebuffer::bind(vtkOpenGLRenderWindow* window, const CubeTexture& color, int face, int level,
                           const CubeTexture* second) {
  vtkOpenGLState* state = window->GetState();
  if (framebuffer_ == 0) glGenFramebuffers(1, &framebuffer_);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, faceTarget(face), color.handle(), level);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, second != nullptr ? faceTarget(face) : GL_TEXTURE_2D,
                         second != nullptr ? second->handle() : 0, second != nullptr ? level : 0);
  const GLenum buffers[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(second != nullptr ? 2 : 1, buffers);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  requireComplete("a cube face");
  const int size = color.faceSize() >> level;
  state->vtkglViewport(0, 0, size, size);
}

void CubeFramebuffer::bindDraw(vtkOpenGLRenderWindow* window) {
  window->GetState()->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
}

void CubeFramebuffer::release() {
  if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
  framebuffer_ = 0;
}

struct PassState::Saved {
  explicit Saved(vtkOpenGLState* state)
      : viewport(state),
        scissorBox(state),
        depthTest(state, GL_DEPTH_TEST),
        blend(state, GL_BLEND),
        scissor(state, GL_SCISSOR_TEST),
        cull(state, GL_CULL_FACE) {}
  vtkOpenGLState::ScopedglViewport viewport;
  vtkOpenGLState::ScopedglScissor scissorBox;
  vtkOpenGLState::ScopedglEnableDisable depthTest, blend, scissor, cull;
};

PassState::PassState(vtkOpenGLRenderWindow* window) : window_(window), saved_(new Saved(window->GetState())) {
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

PassState::~PassState() {
  window_->GetState()->PopFramebufferBindings();
  delete saved_;
}

BoundTexture::BoundTexture(vtkOpenGLRenderWindow* window, GLenum target, GLuint handle)
    : window_(window), target_(target), unit_(window->GetTextureUnitManager()->Allocate()) {
  if (unit_ < 0) throw WorkError("OpenGL has no texture unit left; use fewer textures or probes on one object");
  window_->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit_));
  glBindTexture(target, handle);
}

BoundTexture::~BoundTexture() {
  window_->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit_));
  glBindTexture(target_, 0);
  window_->GetTextureUnitManager()->Free(unit_);
}

}  // namespace boxprobe
