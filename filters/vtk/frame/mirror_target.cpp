#include "filters/vtk/frame/mirror_target.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <algorithm>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

namespace {

constexpr std::array<GLenum, 2> kMirrorBuffers = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

}  // namespace

void MirrorTarget::allocate(int width, int height, int wantedSamples, bool mips) {
  GLint most = 1;  // software renderers may have no more
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const int samples = std::min(wantedSamples, std::max(most, 1));
  int levels = 1;
  for (int size = std::max(width, height); mips && size > 1; size /= 2) ++levels;
  if (resolved_.made() && width == width_ && height == rows_ && samples == samples_ && levels == levels_) return;
  release();
  width_ = width;
  rows_ = height;
  samples_ = samples;
  levels_ = levels;
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  std::vector<FramebufferImage> colors, sampledColors;
  for (GLuint& texture : textures_) {
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    for (int level = 0; level < levels; ++level) {
      glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA16F, std::max(width >> level, 1), std::max(height >> level, 1), 0,
                   GL_RGBA, GL_HALF_FLOAT, nullptr);
    }
    // Outside the picture there are no moving objects.
    const GLfloat border[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
    colors.push_back(textureImage(texture));
  }
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  const auto refusal = [&](GLenum) {
    return "this driver cannot draw a mirror's picture of " + std::to_string(width) + " x " + std::to_string(height) +
           " texels at " + std::to_string(samples) + " samples; lower the mirrors' resolution, or set enabled to false";
  };
  try {
    if (samples <= 1) depth_ = makeRenderBuffer(width, height, 1, GL_DEPTH_COMPONENT32F);
    resolved_.attach(colors, renderBufferImage(depth_), refusal);
    if (samples <= 1) return;
    for (GLuint& buffer : buffers_) {
      buffer = makeRenderBuffer(width, height, samples, GL_RGBA16F);
      sampledColors.push_back(renderBufferImage(buffer));
    }
    sampledDepth_ = makeRenderBuffer(width, height, samples, GL_DEPTH_COMPONENT32F);
    sampled_.attach(sampledColors, renderBufferImage(sampledDepth_), refusal);
  } catch (const WorkError&) {
    release();
    throw;
  }
}

void MirrorTarget::clear(vtkOpenGLRenderWindow* window) {
  const PassState saved(window);
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer());
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_TRUE);
  const GLfloat nothing[4] = {0.0f, 0.0f, 0.0f, 0.0f}, farthest = 1.0f;
  for (int i = 0; i < 2; ++i) glClearBufferfv(GL_COLOR, i, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

// Draw buffers are a state of the framebuffer that VTK does not track, whereas it sets the colour mask itself.
void MirrorTarget::drawColors(vtkOpenGLRenderWindow* window, bool colors) {
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer());
  constexpr GLenum kNone[2] = {GL_NONE, GL_NONE};
  glDrawBuffers(2, colors ? kMirrorBuffers.data() : kNone);
  state->PopFramebufferBindings();
}

void MirrorTarget::finish(vtkOpenGLRenderWindow* window) {
  if (samples_ > 1) {
    vtkOpenGLState* state = window->GetState();
    const PassState saved(window);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->PushFramebufferBindings();
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_.handle());
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.handle());
    for (const GLenum buffer : kMirrorBuffers) {
      glReadBuffer(buffer);
      glDrawBuffer(buffer);
      glBlitFramebuffer(0, 0, width_, rows_, 0, 0, width_, rows_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    glReadBuffer(kMirrorBuffers[0]);
    glDrawBuffers(2, kMirrorBuffers.data());
    state->PopFramebufferBindings();
  }
  if (levels_ == 1) return;
  for (const GLuint texture : textures_) {
    const BoundTexture bound(window, GL_TEXTURE_2D, texture);
    glGenerateMipmap(GL_TEXTURE_2D);
  }
}

std::size_t MirrorTarget::bytes() const {
  const std::size_t texels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_);
  const std::size_t chain = levels_ > 1 ? 4 * texels / 3 : texels;
  const auto samples = static_cast<std::size_t>(std::max(samples_, 1));
  return 2 * 8 * chain + (samples > 1 ? samples * texels * (2 * 8 + 4) : texels * 4);
}

std::shared_ptr<const MirrorTexels> MirrorTarget::readBack() const {
  auto texels = std::make_shared<MirrorTexels>();
  GLint before = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &before);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (int level = 0; level < levels_; ++level) {
    MirrorTexels::Level out;
    out.width = std::max(width_ >> level, 1);
    out.height = std::max(rows_ >> level, 1);
    const std::size_t count = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
    for (auto* values : {&out.color, &out.heights}) {
      values->resize(count);
      glBindTexture(GL_TEXTURE_2D, textures_[values == &out.color ? 0 : 1]);
      glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_FLOAT, &values->front().x);
    }
    texels->levels.push_back(std::move(out));
  }
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(before));
  return texels;
}

void MirrorTarget::release() {
  resolved_.release();
  sampled_.release();
  for (GLuint* buffer : {&depth_, &sampledDepth_, &buffers_[0], &buffers_[1]}) {
    if (*buffer != 0) glDeleteRenderbuffers(1, buffer);
    *buffer = 0;
  }
  for (GLuint& texture : textures_) {
    if (texture != 0) glDeleteTextures(1, &texture);
    texture = 0;
  }
}

}  // namespace boxprobe
