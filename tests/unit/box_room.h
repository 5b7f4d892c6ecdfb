// Rooms that are boxes, and what surfaces in them reflect: a lobe's mean by integration, in double precision and
// independent of the shader's mathematics, to judge and to fit techniques by.
#pragma once

#include <random>
#include <vector>

#include "filters/math/cube_map.h"

namespace boxprobe::test {

/// Walls with a pattern of their own, a lamp and a window: small bright things are the hard case.
struct BoxRoom {
  glm::dvec3 low, high;  ///< the box, relative to the capture origin
  double checks;         ///< along a wall
  double lampRadius;     ///< of the ceiling
  double lampRadiance;
};

/// A capture of the room, prefiltered.
CubeMap prefilteredRoom(const BoxRoom& room, int faceSize);

/// What `point` reflects of level 0 of the chain at the box: the mean over visible normals that the split sum takes.
/// Level 0 and not the room itself, so that the capture's texels are not counted as a technique's error.
glm::dvec3 reflectedMean(const BoxRoom& room, const CubeMap& chain, const shading::ShadingPoint& point, int rays);

/// A point on the floor, on a wall or inside, seen from up to 85 degrees; `index` says where.
shading::ShadingPoint pointInRoom(const BoxRoom& room, float roughness, int index, std::mt19937& random);

/// Errors of a technique: x/(1+x) to the 1/2.2, linear, and of the light in all.
struct ErrorTally {
  double squares = 0.0, linearSquares = 0.0, truthSquares = 0.0, light = 0.0, truthLight = 0.0;
  std::size_t count = 0;
  void add(const glm::dvec3& value, const glm::dvec3& truth);
  double rmse() const;
  double relativeRmse() const;
  double lightRatio() const { return light / truthLight; }
};

}  // namespace boxprobe::test
