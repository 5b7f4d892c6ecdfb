// Averages the frames of a picture in linear light by summing them.
#pragma once

#include <array>
#include <vector>

#include "filters/vtk/gl/frame_target.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

class FrameAverage {
 public:
  explicit FrameAverage(Counters* counters);

  /// The next frame is the first of a new picture.
  void restart() { frames_ = framesBefore_ = 0; }
  /// The next frame is the first of an average that will replace the current one.
  void promote();
  int frames() const { return frames_; }
  /// Adds colour, and the sampled reflection if the frame has it separately.
  void add(vtkOpenGLRenderWindow* window, const FrameTarget& frame);
  /// Sums, to be divided by frames(): attachment 0 colour, 1 the sampled reflection.
  const FrameTarget& sums() const { return targets_[at_]; }
  /// The same for the previous average; framesBefore() of 0: there is none.
  const FrameTarget& sumsBefore() const { return targets_[1 - at_]; }
  int framesBefore() const { return framesBefore_; }
  /// The averaged colours, read back: RGBA, from the lower left.
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
