#include "filters/vtk/gl/frame_target.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <string>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

constexpr std::array<GLenum, FrameTarget::kMostAttachments> kBuffers = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                                                        GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3};

}  // namespace

void FrameTarget::allocate(int width, int height, int samples, int attachments) {
  if (resolved_.made() && width == width_ && height == height_ && samples == samples_ && attachments == attachments_) {
    return;
  }
  release();
  width_ = width;
  height_ = height;
  samples_ = samples;
  attachments_ = attachments;
  std::vector<FramebufferImage> colors;
  for (std::size_t i = 0; i < static_cast<std::size_t>(attachments); ++i) {
    textures_[i] = makeTargetTexture(width, height, GL_RGBA32F, GL_RGBA);
    colors.push_back(textureImage(textures_[i]));
  }
  depth_ = makeTargetTexture(width, height, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
  const auto refusal = [&](GLenum) {
    return "this driver cannot draw " + std::to_string(attachments) + " float pictures of " + std::to_string(width) +
           " x " + std::to_string(height) + " at " + std::to_string(samples) +
           " samples per pixel, which averaging frames needs; switch `animated` and `blur` off, or ask for a smaller "
           "picture";
  };
  try {
    resolved_.attach(colors, textureImage(depth_), refusal);
    if (samples <= 1) return;
    sampledColor_ = makeRenderBuffer(width, height, samples, GL_RGBA32F);
    sampledDepth_ = makeRenderBuffer(width, height, samples, GL_DEPTH_COMPONENT32F);
    sampled_.attach({renderBufferImage(sampledColor_)}, renderBufferImage(sampledDepth_), refusal);
  } catch (const WorkError&) {
    release();
    throw;
  }
}

void FrameTarget::drawTo(bool everyAttachment) const {
  glDrawBuffers(everyAttachment ? attachments_ : 1, kBuffers.data());
}

void FrameTarget::resolve(vtkOpenGLRenderWindow* window) const {
  if (samples_ <= 1) return;
  vtkOpenGLState* state = window->GetState();
  // A scissor rectangle left by earlier draws would clip the copy.
  const vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_.handle());
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.handle());
  const GLbitfield both = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, both, GL_NEAREST);
  state->PopFramebufferBindings();
}

void FrameTarget::release() {
  resolved_.release();
  sampled_.release();
  if (depth_ != 0) glDeleteTextures(1, &depth_);
  if (sampledColor_ != 0) glDeleteRenderbuffers(1, &sampledColor_);
  if (sampledDepth_ != 0) glDeleteRenderbuffers(1, &sampledDepth_);
  for (GLuint& texture : textures_) {
    if (texture != 0) glDeleteTextures(1, &texture);
    texture = 0;
  }
  depth_ = sampledColor_ = sampledDepth_ = 0;
}

}  // namespace boxprobe
