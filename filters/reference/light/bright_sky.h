// Directions towards the parts of a sky that are much brighter than its mean, such as the sun, for sampling.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "filters/reference/trace/bright_directions.h"

namespace boxprobe {

class BrightSky {
 public:
  /// Reads level 0 of `sky`.
  explicit BrightSky(const CubeMap& sky) : directions_(sky) {}

  /// Nothing is much brighter than the mean: sampling the lobe is enough.
  bool empty() const { return directions_.groups() == 0; }
  /// The part of the sky's radiance above the threshold.
  glm::dvec3 excess(const glm::dvec3& radiance) const { return directions_.excess(radiance); }
  /// Draws a unit direction, world, from two numbers in [0, 1), in proportion to the light above the threshold.
  glm::dvec3 towards(const glm::dvec2& u) const;
  /// The density of towards() per solid angle.
  double density(const glm::dvec3& directionWorld) const;

 private:
  BrightDirections directions_;
};

}  // namespace boxprobe
