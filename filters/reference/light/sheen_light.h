// Sheen for the references: the lobe is evaluated per ray, and its albedo integrated here.
#pragma once

#include <glm/vec3.hpp>

#include "filters/core/surface/surface_point.h"

namespace boxprobe {

/// Albedo at `nDotV`, at most 1: integrated over 96 x 96 directions, bilinear between 33 x 33 nodes over the root of
/// the cosine and the roughness.
double sheenShare(double nDotV, double roughness);

/// The fraction of light that the sheen passes to the layers below; 1 without sheen.
double sheenPasses(const SurfacePoint& surface);

/// f cos of the surface's sheen for light from `direction` (unit); 0 below the surface or without sheen.
glm::dvec3 sheenSent(const SurfacePoint& surface, const glm::dvec3& direction);

}  // namespace boxprobe
