// What stands in the way of a fit. Called by fit_box.
#pragma once

#include "filters/fit/box/reflected_rays.h"

namespace boxprobe {

/// Share of the directions within 30 degrees of the horizon in which upright surfaces are seen.
double walledAround(const SurfaceRays& rays, const glm::dvec3& originWorld);

/// Is the origin within something solid? Most rays meet back sides there and, further on, the front sides of the room.
/// In a room whose faces are inverted they meet back sides, too, but nothing behind those, or the next room at once.
bool insideOfSolid(const SurfaceRays& rays, const glm::dvec3& originWorld);

}  // namespace boxprobe
