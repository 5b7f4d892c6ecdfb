// The conversion between directions and places in environment pictures: the conventions of OpenGL's cubes, OpenEXR's
// cubes and latitude-longitude maps.
//
//   a face's picture   OpenGL (also Unity, CubeMapGen, Direct3D)     OpenEXR (as seen from inside, right-handed)
//                      to the right   down                           to the right   down
//   +X                 -Z             -Y                             +Z             -Y
//   -X                 +Z             -Y                             -Z             -Y
//   +Y                 +X             +Z                             +X             -Z
//   -Y                 +X             -Z                             +X             +Z
//   +Z                 +X             -Y                             -X             -Y
//   -Z                 -X             -Y                             +X             -Y
//
// So OpenEXR's faces are OpenGL's, mirrored. OpenGL's texels tile a face; OpenEXR's first and last lie on its edges, so
// neighbouring faces repeat them. Latitude-longitude: top row +Y, middle +Z, a quarter from the left +X, the left and
// right edge -Z, for both placements of texels.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// Texels lie at the centres of cells (OpenGL, most pictures), or the first and last lie on the edges (OpenEXR).
enum class TexelPlacement { Centres, Edges };

/// Position in texels (0 is the first texel) of a coordinate in [-1, 1], and back.
double texelPosition(double coordinate, int count, TexelPlacement placement);
double texelCoordinate(double position, int count, TexelPlacement placement);

/// OpenEXR's faces have OpenGL's s (X and Z faces) or t (Y faces) reversed; an involution.
CubePoint mirroredOpenExr(CubePoint point);

/// The cell of a face in a picture of several, in units of faces, OpenGL's order.
struct FaceCell {
  int column, row;
  bool turned = false;  ///< by 180 degrees
};
using FaceCells = std::array<FaceCell, 6>;
constexpr FaceCells kRow = {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}};
constexpr FaceCells kColumn = {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}};
/// Unfolded around +Z so that neighbours meet as on the cube: -Z is right of +X, or rotated below -Y.
constexpr FaceCells kCrossWide = {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
constexpr FaceCells kCrossTall = {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}};

/// x to the right, y down, both [-1, 1].
glm::vec3 latLongDirection(double x, double y);
glm::dvec2 latLongPoint(const glm::vec3& direction);

}  // namespace boxprobe
