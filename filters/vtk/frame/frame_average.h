// The mean of the frames of a picture in linear light: sums of what each frame drew. Called by vtkPicturePass, which
// decides when a picture begins again; knows no scene.
#pragma once

#include <array>
#include <vector>

#include "filters/vtk/gl/frame_target.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

class FrameAverage {
 public:
  explicit FrameAverage(Counters* counters);

  /// The next frame is the first, of a picture that replaces nothing.
  void restart() { frames_ = framesBefore_ = 0; }
  /// The next frame is the first of a mean that will replace this one.
  void promote();
  int frames() const { return frames_; }
  /// Adds colour, and the sampled reflection where the frame keeps that apart.
  void add(vtkOpenGLRenderWindow* window, const FrameTarget& frame);
  /// Sums, to be divided by frames(): attachment 0 colour, 1 the sampled reflection.
  const FrameTarget& sums() const { return targets_[at_]; }
  /// The same of the mean before; framesBefore() of 0: there is none.
  const FrameTarget& sumsBefore() const { return targets_[1 - at_]; }
  int framesBefore() const { return framesBefore_; }
  /// The mean's colours, read back: RGBA, from the lower left.
  std::vector<float> mean(vtkOpenGLRenderWindow* window) const;
  std::vector<float> meanBefore(vtkOpenGLRenderWindow* window) const;
  void releaseSums();
  void release();

 private:
  std::array<FrameTarget, 2> targets_;
  std::size_t at_ = 0;
  FullScreenPass color_, apart_;
  int frames_ = 0, framesBefore_ = 0;
};

}  // namespace boxprobe
