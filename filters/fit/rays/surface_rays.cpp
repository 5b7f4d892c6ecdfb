// See surface_rays.h.
#include "filters/fit/rays/surface_rays.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

std::vector<glm::dvec3> fibonacciDirections(int count, double turn) {
  const double pi = std::acos(-1.0), golden = pi * (3.0 - std::sqrt(5.0));
  std::vector<glm::dvec3> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double y = 1.0 - (2.0 * i + 1.0) / count;
    const double radius = std::sqrt(std::max(0.0, 1.0 - y * y)), angle = golden * i + 2.0 * pi * turn;
    directions.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
  }
  return directions;
}

glm::dvec3 sphereDirection(double u, double v) {
  const double y = 1.0 - 2.0 * u, radius = std::sqrt(std::max(0.0, 1.0 - y * y)), angle = 2.0 * std::acos(-1.0) * v;
  return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

}  // namespace boxprobe
