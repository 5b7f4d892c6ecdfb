// Filters levels of a chain that was made without them, from its level 0, which is the capture itself. Called when a
// material, a view or a file comes to need them. Makes the same texels as if they had been filtered at once.
#pragma once

#include "filters/vtk/capture/prefilter.h"

namespace boxprobe {

class LevelFilter {
 public:
  /// `prefilter`: with its programs; must outlive this.
  LevelFilter(vtkOpenGLRenderWindow* window, Prefilter* prefilter);

  /// `chain` holds its capture in level 0, unblurred. Makes the window's context current.
  void make(const CubeTexture& chain, LevelMask levels, const PrefilterSettings& settings);
  void release();

 private:
  vtkOpenGLRenderWindow* window_;
  Prefilter* prefilter_;
  CubeTexture source_;
};

}  // namespace boxprobe
