// Smooths the sampled reflections of a picture, separate from everything else in it
// (shaders/gpu/reflection_apart.glsl), and not across surface edges. Needs the window's context current.
#pragma once

#include "filters/vtk/gl/frame_target.h"
#include "filters/vtk/gl/full_screen_pass.h"

class vtkCamera;

namespace boxprobe {

class ReflectionBlur {
 public:
  explicit ReflectionBlur(Counters* counters);

  /// `sums`: colour and sampled reflection of `frames` frames. `surfaces`: one of these frames. `rays`: per pixel, in
  /// all frames together.
  void draw(vtkOpenGLRenderWindow* window, vtkCamera* camera, const FrameTarget& sums, int frames,
            const FrameTarget& surfaces, int rays);
  /// The averaged picture.
  GLuint color() const { return smoothed_.texture(0); }
  void releaseTargets();
  void release();

 private:
  FullScreenPass first_, last_;
  FrameTarget half_, smoothed_;
};

}  // namespace boxprobe
