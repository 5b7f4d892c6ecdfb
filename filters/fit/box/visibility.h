// Visibility between points.
#pragma once

#include <glm/geometric.hpp>

#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

/// World positions. `position` may lie on a surface: tolerates a thousandth of the distance.
inline bool visibleFrom(const SurfaceRays& rays, const glm::dvec3& eye, const glm::dvec3& position) {
  const glm::dvec3 to = position - eye;
  const double distance = glm::length(to);
  if (!(distance > 0.0)) return true;
  const std::optional<SurfaceHit> hit = rays.first(eye, to / distance);
  return !hit || hit->distance >= 0.999 * distance;
}

}  // namespace boxprobe
