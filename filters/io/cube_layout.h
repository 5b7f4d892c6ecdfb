// Where a direction lies in a picture of the surroundings, and back: the conventions of OpenGL's cubes, OpenEXR's cubes
// and latitude-longitude maps in one place. Called by the readers and writers of cubes; knows no files and no values.
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
// OpenEXR's is thus OpenGL's, mirrored. OpenGL's texels tile a face; OpenEXR's first and last lie on its edges, so
// neighbouring faces repeat them. Latitude-longitude: top row +Y, middle +Z, a quarter from the left +X, the left and
// right edge -Z, in both conventions of texels.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "filters/math/cube_map.h"

namespace boxprobe {

/// Where texels sit: at the centres of cells (OpenGL, most pictures), or with the first and last on the edges
/// (OpenEXR).
enum class TexelPlacement { Centres, Edges };

/// Position in texels (0 the first one's own place) of a coordinate in [-1, 1], and back.
double texelPosition(double coordinate, int count, TexelPlacement placement);
double texelCoordinate(double position, int count, TexelPlacement placement);

/// OpenEXR's faces have OpenGL's s (X and Z faces) or t (Y faces) reversed; its own inverse.
CubePoint mirroredOpenExr(CubePoint point);

/// x to the right, y down, both [-1, 1].
glm::vec3 latLongDirection(double x, double y);
glm::dvec2 latLongPoint(const glm::vec3& direction);

}  // namespace boxprobe
