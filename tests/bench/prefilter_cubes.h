// The cubemaps that prefilters are measured on.
#pragma once

#include <string>
#include <vector>

#include "filters/math/cube/cube_map.h"

class vtkOpenGLRenderWindow;

namespace boxprobe::bench {

struct NamedCube {
  std::string name;
  CubeMap cube;  ///< level 0 only, alpha 1, half-float values
};

/// A sky with its sun, a captured room with a lamp in its ceiling, and a single texel 50,000 times as bright as the
/// rest.
std::vector<NamedCube> prefilterCubes(vtkOpenGLRenderWindow* window, int faceSize);

}  // namespace boxprobe::bench
