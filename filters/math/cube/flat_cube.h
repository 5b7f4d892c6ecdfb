// A cubemap laid out flat: faces with a border of the texels beyond their edges, so that a plain bilinear lookup within
// a face gives what a seamless cubemap gives. For software renderers, whose cubemap lookups are dear, and for
// calculations that look up millions of times. Plain arithmetic; knows no OpenGL.
#pragma once

#include <vector>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// (size + 2)² texels of a face, rows along t, its own from column and row 1 on. Beyond an edge lie the texels of the
/// face that adjoins there, and in a corner the mean of the three that meet.
std::vector<glm::vec4> paddedFace(const CubeMap& cube, int level, int face);

/// One picture of all padded faces: side by side, faces in OpenGL's order, the levels below each other, the finest
/// first. shaders/gpu/flat_lookup.glsl looks it up.
struct FlatCube {
  int width = 0, height = 0;
  std::vector<float> rgba;  ///< width x height x 4, rows along t; 0 beside the coarser levels
};
FlatCube flattenCube(const CubeMap& cube);

}  // namespace boxprobe
