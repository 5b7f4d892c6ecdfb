// Cloth's sheen as the references have it: the lobe evaluated ray by ray, and its share of even light integrated here.
// Called by both references and by the light of captures.
#pragma once

#include <glm/vec3.hpp>

#include "filters/core/surface/surface_point.h"

namespace boxprobe {

/// Share of even light that the lobe sends to an eye at `nDotV`, at most 1: its integral by 96 x 96 directions,
/// bilinear between 33 x 33 corners over the root of the cosine and the roughness.
double sheenShare(double nDotV, double roughness);

/// What of the light a surface's sheen leaves to what lies under it; 1 without one.
double sheenPasses(const SurfacePoint& surface);

/// f cos of the surface's sheen for light from `direction` (unit); 0 below the surface or without one.
glm::dvec3 sheenSent(const SurfacePoint& surface, const glm::dvec3& direction);

}  // namespace boxprobe
