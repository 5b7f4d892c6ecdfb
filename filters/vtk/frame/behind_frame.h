// What glass is looked through at: a copy of the opaque part of a frame, colour with mip levels and depth, because a
// framebuffer cannot be read while it is drawn into. Called by vtkPicturePass; knows no scene. Every function needs the
// window's context current.
#pragma once

#include "filters/vtk/draw/pass_settings.h"
#include "filters/vtk/gl/frame_target.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

class BehindFrame {
 public:
  explicit BehindFrame(Counters* counters);
  ~BehindFrame() { releaseTextures(); }
  BehindFrame(const BehindFrame&) = delete;
  BehindFrame& operator=(const BehindFrame&) = delete;

  /// Copies what `frame` holds, its samples resolved: premultiplied by coverage, so that levels mix nothing in where
  /// nothing was drawn. Throws WorkError if the driver refuses.
  BehindPicture take(vtkOpenGLRenderWindow* window, const FrameTarget& frame);
  /// The copy's memory; the next take() has it again. The context must be current.
  void releaseTextures();
  /// And the program, before the context goes.
  void release();

 private:
  void allocate(int width, int height);

  FullScreenPass copy_;
  Framebuffer framebuffer_;
  BehindPicture picture_;
};

}  // namespace boxprobe
