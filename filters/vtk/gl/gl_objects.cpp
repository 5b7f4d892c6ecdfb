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

// Creating and reading need a binding outside VTK's texture unit bookkeeping, on whatever unit is active; restored
// afterwards.
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

}  // namespace

std::string seamlessCubesProblem() {
  // Restored, because VTK tracks this state.
  const bool before = glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS) == GL_TRUE;
  if (before) return {};
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  const bool works = glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS) == GL_TRUE;
  glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  if (works) return {};
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
  while (glGetError() != GL_NO_ERROR) {  // discards earlier errors, which are not from this allocation
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
  // Distances are not interpolated: the mean of two distances is a surface that does not exist.
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER,
                  nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
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
  readFace(face, level, rgba.data());
  return rgba;
}

void CubeTexture::readFace(int face, int level, float* rgba) const {
  const CubeBinding binding(handle_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTexImage(faceTarget(face), level, GL_RGBA, GL_FLOAT, rgba);
}

void CubeTexture::writeFace(int face, int level, const std::vector<float>& rgba) {
  const CubeBinding binding(handle_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(faceTarget(face), level, 0, 0, faceSize_ >> level, faceSize_ >> level, GL_RGBA, GL_FLOAT,
                  rgba.data());
}

void CubeTexture::writeHalves(int face, int level, const std::uint16_t* rgba) {
  const CubeBinding binding(handle_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(faceTarget(face), level, 0, 0, faceSize_ >> level, faceSize_ >> level, GL_RGBA, GL_HALF_FLOAT, rgba);
}

void FloatTarget::allocate(int width, int height) {
  if (framebuffer_.made() && width == width_ && height == height_) return;
  release();
  width_ = width;
  height_ = height;
  color_ = makeTargetTexture(width, height, GL_RGBA32F, GL_RGBA);
  depth_ = makeTargetTexture(width, height, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
  framebuffer_.attach({textureImage(color_)}, textureImage(depth_), floatRefusal("float colour"));
}

void FloatTarget::release() {
  framebuffer_.release();
  if (color_ != 0) glDeleteTextures(1, &color_);
  if (depth_ != 0) glDeleteTextures(1, &depth_);
  color_ = depth_ = 0;
}

void CubeFramebuffer::bind(vtkOpenGLRenderWindow* window, const CubeTexture& color, int face, int level,
                           const CubeTexture* second) {
  std::vector<FramebufferImage> images = {textureImage(color.handle(), faceTarget(face), level)};
  if (second != nullptr) images.push_back(textureImage(second->handle(), faceTarget(face), level));
  framebuffer_.attach(images, {}, floatRefusal("a cube face"));
  vtkOpenGLState* state = window->GetState();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.handle());
  const int size = color.faceSize() >> level;
  state->vtkglViewport(0, 0, size, size);
}

void CubeFramebuffer::bindDraw(vtkOpenGLRenderWindow* window) {
  window->GetState()->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.handle());
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
  state->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
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
