// See room_probe.h.
#include "filters/fit/room_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

Probe roomProbe(const TriangleRays& rays, const StandingPoint& stand) {
  constexpr int kRays = 2048;
  constexpr double kFacing = 0.7071;
  const glm::dvec3 origin = stand.eyeWorld;
  std::array<std::vector<double>, 6> distances;  // -x, +x, -y, +y, -z, +z
  for (const glm::dvec3& direction : fibonacciDirections(kRays)) {
    const std::optional<SurfaceHit> hit = rays.first(origin, direction);
    if (!hit) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(hit->normalWorld[axis]) < kFacing) continue;
      const double along = hit->distance * direction[axis];
      if (along * hit->normalWorld[axis] < 0.0) {
        distances[static_cast<std::size_t>(2 * axis + (along > 0.0 ? 1 : 0))].push_back(std::abs(along));
      }
    }
  }
  const Box& bounds = rays.bounds();
  const double diagonal = glm::length(bounds.size());
  const double margin = std::max(1e-3 * diagonal, 1e-6);  // walls lie inside the box, not on its faces
  Probe probe;
  probe.origin = origin;
  for (int axis = 0; axis < 3; ++axis) {
    for (int end = 0; end < 2; ++end) {
      std::vector<double>& found = distances[static_cast<std::size_t>(2 * axis + end)];
      double distance = end == 1 ? bounds.max[axis] - origin[axis] : origin[axis] - bounds.min[axis];
      if (found.size() >= kRays / 200) {
        const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
        std::nth_element(found.begin(), middle, found.end());
        distance = *middle;
      }
      distance = std::max(distance, 0.0) + margin;
      (end == 1 ? probe.box.max : probe.box.min)[axis] = origin[axis] + (end == 1 ? distance : -distance);
    }
  }
  // Other rooms, alcoves and what is behind the median wall have no probe of their own: this one is closer to the truth
  // there than the sky.
  const Box whole{glm::min(bounds.min - margin, probe.box.min), glm::max(bounds.max + margin, probe.box.max)};
  probe.influence = whole;
  probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
  probe.nearDistance = std::max(std::min(1e-4 * diagonal, 0.1 * stand.clearance), 1e-6);
  probe.farDistance = std::max(2.0 * diagonal, probe.nearDistance * 10.0);
  return probe;
}

}  // namespace boxprobe
