// A cubemap laid out flat: each face has a border of the texels beyond its edges, so a plain bilinear lookup within a
// face gives what a seamless cubemap gives. For software renderers, whose cubemap lookups are expensive, and for
// calculations with millions of lookups.
#pragma once

#include <vector>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// A face with its border: (size + 2)² texels, rows along t; its own texels start at column and row 1. Beyond an edge
/// lie the texels of the adjoining face; in a corner, the mean of the three texels that meet there.
std::vector<glm::vec4> paddedFace(const CubeMap& cube, int level, int face);

/// All padded faces in one picture: faces side by side in OpenGL's order, levels below each other, the finest first.
/// Sampled by shaders/gpu/flat_lookup.glsl.
struct FlatCube {
  int width = 0, height = 0;
  std::vector<float> rgba;  ///< width x height x 4, rows along t; 0 beside the coarser levels
};
FlatCube flattenCube(const CubeMap& cube);

}  // namespace boxprobe
