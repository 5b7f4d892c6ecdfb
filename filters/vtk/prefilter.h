// From a capture to the chain that lookups read: level 0 copied, each further level filtered by the GGX lobe of the
// roughness it stands for. One level a call, so that a window stays responsive.
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <vector>

#include "filters/vtk/draw_state.h"
#include "filters/vtk/full_screen_pass.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Levels of a chain for a face size: the last one has 4 x 4 texels, enough for the lobe of roughness 1.
int prefilterLevels(int faceSize);

/// Directions in the frame of R (z) with weight z, and in w the level of the source's mip chain to fetch: the lobe of
/// perceptual roughness `roughness` for N = V = R. The directions follow the distribution D(h) cut at the horizon, on a
/// Fibonacci spiral, so they are even in azimuth and solid angle for any count.
std::vector<glm::vec4> lobeSamples(float roughness, int count, int sourceFaceSize);

class Prefilter {
 public:
  Prefilter(vtkOpenGLRenderWindow* window, Counters* counters);

  /// The source's own mip levels (box filter) and a copy of its level 0 into the chain. Source and chain are allocated;
  /// the source needs as many levels as its size allows.
  void begin(const CubeTexture& source, const CubeTexture& chain);
  /// Level 1 and up.
  void filterLevel(const CubeTexture& source, const CubeTexture& chain, int level);
  /// Diffuse irradiance from a small level of the source.
  static ShCoefficients irradiance(const CubeTexture& source);

  void release();

  static constexpr int kSamples = 64;

 private:
  vtkOpenGLRenderWindow* window_;
  Counters* counters_;
  CubeFramebuffer from_, to_;
  FullScreenPass pass_;
};

}  // namespace boxprobe
