// A copy of the opaque part of a frame, to be seen through glass: colour with mip levels, and depth. A framebuffer
// cannot be read while it is drawn to. Every function needs the window's context current.
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

  /// Copies the resolved contents of `frame`, premultiplied by coverage, so that empty pixels do not contribute to mip
  /// levels. Throws WorkError if the driver refuses.
  BehindPicture take(vtkOpenGLRenderWindow* window, const FrameTarget& frame);
  /// Releases the copy's memory; the next take() allocates it again. The context must be current.
  void releaseTextures();
  /// Releases the program as well, before the context is destroyed.
  void release();

 private:
  void allocate(int width, int height);

  FullScreenPass copy_;
  Framebuffer framebuffer_;
  BehindPicture picture_;
};

}  // namespace boxprobe
