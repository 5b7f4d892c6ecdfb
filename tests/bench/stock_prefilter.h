// The yardstick of the prefilter: VTK's own, on the same cubemap.
#pragma once

#include <vtkSmartPointer.h>

#include "filters/math/cube/cube_map.h"

class vtkOpenGLRenderWindow;
class vtkPBRPrefilterTexture;
class vtkRenderer;

namespace boxprobe::bench {

class StockPrefilter {
 public:
  /// `levels` and `samples` as VTK's defaults; the input's mip levels are made here, outside of what is timed.
  StockPrefilter(vtkOpenGLRenderWindow* window, const CubeMap& input, int levels = 5, int samples = 512);
  ~StockPrefilter();

  /// All levels. Returns the CPU time, seconds, all threads.
  double filter();
  /// What the last one made. Level 0 is a copy of the input.
  CubeMap read() const;
  int levels() const;
  /// Perceptual roughness that VTK filters a level for, and the one whose lookups land on it: they differ.
  float bakedRoughness(int level) const;
  float levelLookedUp(float roughness) const;

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPBRPrefilterTexture> prefilter_;
  vtkOpenGLRenderWindow* window_;
  int faceSize_;
};

}  // namespace boxprobe::bench
