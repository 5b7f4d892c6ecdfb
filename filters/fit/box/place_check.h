// What stands in the way of a fit. Called by fit_box.
#pragma once

#include "filters/fit/box/reflected_rays.h"

namespace boxprobe {

/// Share of the directions within 30 degrees of the horizon in which upright surfaces are seen.
double walledAround(const SurfaceRays& rays, const glm::dvec3& originWorld);

/// Is the origin within something solid? Most rays meet back sides there and, not far behind those, the front sides of
/// the room; in a room whose faces are inverted, too, they meet back sides, but far away.
bool insideOfSolid(const SurfaceRays& rays, const glm::dvec3& originWorld);

}  // namespace boxprobe
