// The mean of the frames of a picture in linear light: sums of what each frame drew. Called by vtkPicturePass, which
// decides when a picture begins again; knows no scene.
#pragma once

#include "filters/vtk/gl/frame_target.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

class FrameAverage {
 public:
  explicit FrameAverage(Counters* counters);

  /// The next frame is the first.
  void restart() { frames_ = 0; }
  int frames() const { return frames_; }
  /// Adds colour, and the sampled reflection where the frame keeps that apart.
  void add(vtkOpenGLRenderWindow* window, const FrameTarget& frame);
  /// Sums, to be divided by frames(): attachment 0 colour, 1 the sampled reflection.
  const FrameTarget& sums() const { return sums_; }
  void releaseSums();
  void release();

 private:
  FrameTarget sums_;
  FullScreenPass color_, apart_;
  int frames_ = 0;
};

}  // namespace boxprobe
