#include "filters/core/geometry/lamp_reach.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace boxprobe {

bool lampReaches(const SceneLamp& lamp, const Box& box, double roughness, double least) {
  const glm::dvec3 size = box.max - box.min;
  if (!(size.x >= 0.0 && size.y >= 0.0 && size.z >= 0.0)) return true;
  // The box's corner farthest along the lamp's normal, with room for the rounding of what is drawn.
  const glm::dvec3 half = 0.5 * size;
  const double height = glm::dot(lamp.normal, box.min + half - lamp.middle) + glm::dot(glm::abs(lamp.normal), half);
  if (!lamp.bothSides && height <= -1.0e-5 * glm::length(size)) return false;
  glm::dvec3 low = lamp.corners.front(), high = low;
  for (const glm::dvec3& corner : lamp.corners) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  const double distance = glm::length(glm::max(glm::max(low - box.max, box.min - high), glm::dvec3(0.0)));
  const double radiance = std::max({lamp.radiance.x, lamp.radiance.y, lamp.radiance.z});
  if (!(distance > 0.0)) return radiance >= least;
  const double solidAngle = std::min(lamp.area / (distance * distance), 2.0 * glm::pi<double>());
  // f cos is at most D G1 / (4 N.V), D at most 1 / (pi alpha²) and G1 / N.V at most 2 / alpha.
  const double alpha = std::clamp(roughness * roughness, 1.0e-4, 1.0);
  const double glossy = std::min(solidAngle / (2.0 * glm::pi<double>() * alpha * alpha * alpha), 1.0);
  const double diffuse = std::min(solidAngle / glm::pi<double>(), 1.0);
  return radiance * (glossy + diffuse) >= least;
}

}  // namespace boxprobe
