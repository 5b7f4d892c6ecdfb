#include "filters/vtk/frame/frame_average.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <memory>

#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

FrameAverage::FrameAverage(Counters* counters)
    : color_({"gpu/add_frame.glsl"}, counters), apart_({"gpu/add_frame_apart.glsl"}, counters) {}

void FrameAverage::add(vtkOpenGLRenderWindow* window, const FrameTarget& frame) {
  const bool apart = frame.attachments() > 1;
  FrameTarget& sums = targets_[at_];
  sums.allocate(frame.width(), frame.height(), 0, apart ? 2 : 1);
  vtkOpenGLState* state = window->GetState();
  const PassState saved(window);
  const vtkOpenGLState::ScopedglBlendFuncSeparate blend(state);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, sums.framebuffer());
  state->vtkglViewport(0, 0, frame.width(), frame.height());
  if (frames_ > 0) {
    // The first frame overwrites the contents, which may be NaN.
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  const BoundTexture color(window, GL_TEXTURE_2D, frame.texture(0));
  std::unique_ptr<BoundTexture> reflection;
  if (apart) reflection = std::make_unique<BoundTexture>(window, GL_TEXTURE_2D, frame.texture(1));
  (apart ? apart_ : color_).draw(window, [&](vtkShaderProgram* program) {
    program->SetUniformi("bpColor", color.unit());
    if (reflection) program->SetUniformi("bpReflection", reflection->unit());
  });
  ++frames_;
}

void FrameAverage::promote() {
  framesBefore_ = frames_;
  frames_ = 0;
  at_ = 1 - at_;
}

namespace {

std::vector<float> meanOf(vtkOpenGLRenderWindow* window, const FrameTarget& sums, int frames) {
  std::vector<float> pixels(static_cast<std::size_t>(sums.width()) * static_cast<std::size_t>(sums.height()) * 4);
  if (frames <= 0) return pixels;
  const BoundTexture bound(window, GL_TEXTURE_2D, sums.texture(0));
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(bound.unit()));
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels.data());
  const float scale = 1.0f / static_cast<float>(frames);
  for (float& value : pixels) value *= scale;
  return pixels;
}

}  // namespace

std::vector<float> FrameAverage::mean(vtkOpenGLRenderWindow* window) const {
  return meanOf(window, sums(), frames_);
}

std::vector<float> FrameAverage::meanBefore(vtkOpenGLRenderWindow* window) const {
  return meanOf(window, sumsBefore(), framesBefore_);
}

void FrameAverage::releaseSums() {
  for (FrameTarget& target : targets_) target.release();
  restart();
}

void FrameAverage::release() {
  releaseSums();
  color_.release();
  apart_.release();
}

}  // namespace boxprobe
