// Conditions under which a box cannot be fitted.
#pragma once

#include "filters/fit/box/reflected_rays.h"

namespace boxprobe {

/// Share of the directions within 30 degrees of the horizon in which upright surfaces are seen.
double walledAround(const SurfaceRays& rays, const glm::dvec3& originWorld);

/// Is the origin inside something solid? Most rays then meet back sides and, further on, the front sides of the room.
/// In a room with inverted faces they also meet back sides, but nothing behind them, or the next room at once.
bool insideOfSolid(const SurfaceRays& rays, const glm::dvec3& originWorld);

}  // namespace boxprobe
