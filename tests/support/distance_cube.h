// Distances as a capture would hold them, from rays. Called by tests and measurements of the fit.
#pragma once

#include <glm/mat3x3.hpp>

#include "filters/fit/rays/surface_rays.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe::test {

/// One level of `size` squared faces; red holds the distance from `originWorld`, 0 where nothing is met.
CubeMap distanceCube(const SurfaceRays& rays, const glm::dvec3& originWorld, const glm::dmat3& worldFromMap, int size);

}  // namespace boxprobe::test
