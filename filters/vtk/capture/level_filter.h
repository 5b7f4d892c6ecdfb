// Filters missing levels of a chain later, from its level 0, which is the capture itself. Makes the same texels as
// filtering at once.
#pragma once

#include "filters/vtk/capture/prefilter.h"

namespace boxprobe {

class LevelFilter {
 public:
  /// `prefilter` provides the programs and must outlive this object.
  LevelFilter(vtkOpenGLRenderWindow* window, Prefilter* prefilter);

  /// `chain` holds its unblurred capture in level 0. Makes the window's context current.
  void make(const CubeTexture& chain, LevelMask levels, const PrefilterSettings& settings);
  void release();

 private:
  vtkOpenGLRenderWindow* window_;
  Prefilter* prefilter_;
  CubeTexture source_;
};

}  // namespace boxprobe
