// Smooths the sampled reflections of a picture, apart from everything else in it and not across edges of surfaces.
// Called by vtkPicturePass with what a frame keeps apart (shaders/gpu/reflection_apart.glsl); knows no scene. The
// window's context must be current.
#pragma once

#include "filters/vtk/gl/frame_target.h"
#include "filters/vtk/gl/full_screen_pass.h"

class vtkCamera;

namespace boxprobe {

class ReflectionBlur {
 public:
  explicit ReflectionBlur(Counters* counters);

  /// `sums`: of `frames` frames, colour and sampled reflection. `surfaces`: one of these frames. `rays`: a pixel, of
  /// all frames together.
  void draw(vtkOpenGLRenderWindow* window, vtkCamera* camera, const FrameTarget& sums, int frames,
            const FrameTarget& surfaces, int rays);
  /// The picture, a mean.
  GLuint color() const { return smoothed_.texture(0); }
  void releaseTargets();
  void release();

 private:
  FullScreenPass first_, last_;
  FrameTarget half_, smoothed_;
};

}  // namespace boxprobe
