#include "filters/vtk/gl/frame_target.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <string>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

constexpr std::array<GLenum, FrameTarget::kMostAttachments> kBuffers = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                                                        GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3};

GLuint makeTexture(int width, int height, GLenum internalFormat, GLenum format) {
  GLuint handle = 0;
  glGenTextures(1, &handle);
  glBindTexture(GL_TEXTURE_2D, handle);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), width, height, 0, format, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return handle;
}

GLuint makeBuffer(int width, int height, int samples, GLenum internalFormat) {
  GLuint handle = 0;
  glGenRenderbuffers(1, &handle);
  glBindRenderbuffer(GL_RENDERBUFFER, handle);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internalFormat, width, height);
  return handle;
}

}  // namespace

void FrameTarget::allocate(int width, int height, int samples, int attachments) {
  if (resolved_ != 0 && width == width_ && height == height_ && samples == samples_ && attachments == attachments_) {
    return;
  }
  release();
  width_ = width;
  height_ = height;
  samples_ = samples;
  attachments_ = attachments;
  GLint texture = 0, bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGenFramebuffers(1, &resolved_);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
  for (std::size_t i = 0; i < static_cast<std::size_t>(attachments); ++i) {
    textures_[i] = makeTexture(width, height, GL_RGBA32F, GL_RGBA);
    glFramebufferTexture2D(GL_FRAMEBUFFER, kBuffers[i], GL_TEXTURE_2D, textures_[i], 0);
  }
  depth_ = makeTexture(width, height, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  drawTo(true);
  bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (samples > 1) {
    glGenFramebuffers(1, &sampled_);
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_);
    sampledColor_ = makeBuffer(width, height, samples, GL_RGBA32F);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, sampledColor_);
    sampledDepth_ = makeBuffer(width, height, samples, GL_DEPTH_COMPONENT32F);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, sampledDepth_);
    complete = complete && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture));
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
  if (complete) return;
  release();
  throw WorkError("this driver cannot draw " + std::to_string(attachments) + " float pictures of " +
                  std::to_string(width) + " x " + std::to_string(height) + " at " + std::to_string(samples) +
                  " samples a pixel, which averaging frames needs; switch `animated` and `blur` off, or ask for a "
                  "smaller picture");
}

void FrameTarget::drawTo(bool everyAttachment) const {
  glDrawBuffers(everyAttachment ? attachments_ : 1, kBuffers.data());
}

void FrameTarget::resolve(vtkOpenGLRenderWindow* window) const {
  if (samples_ <= 1) return;
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  const GLbitfield both = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, both, GL_NEAREST);
  state->PopFramebufferBindings();
}

void FrameTarget::release() {
  if (resolved_ != 0) glDeleteFramebuffers(1, &resolved_);
  if (sampled_ != 0) glDeleteFramebuffers(1, &sampled_);
  if (depth_ != 0) glDeleteTextures(1, &depth_);
  if (sampledColor_ != 0) glDeleteRenderbuffers(1, &sampledColor_);
  if (sampledDepth_ != 0) glDeleteRenderbuffers(1, &sampledDepth_);
  for (GLuint& texture : textures_) {
    if (texture != 0) glDeleteTextures(1, &texture);
    texture = 0;
  }
  resolved_ = sampled_ = depth_ = sampledColor_ = sampledDepth_ = 0;
}

}  // namespace boxprobe
