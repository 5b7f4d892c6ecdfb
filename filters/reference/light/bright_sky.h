// Where a sky is much brighter than its mean, a sun above all: directions to draw rays towards. Called by the scene
// reference; knows no surface.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "filters/reference/trace/bright_directions.h"

namespace boxprobe {

class BrightSky {
 public:
  /// `sky`: level 0 of it is read.
  explicit BrightSky(const CubeMap& sky) : directions_(sky) {}

  /// Nothing stands out: rays by the lobe alone do as well.
  bool empty() const { return directions_.groups() == 0; }
  /// What of the sky's radiance stands out.
  glm::dvec3 excess(const glm::dvec3& radiance) const { return directions_.excess(radiance); }
  /// A unit direction, world, by two numbers in [0, 1); in proportion to the light that stands out.
  glm::dvec3 towards(const glm::dvec2& u) const;
  /// How densely towards() draws it, per solid angle.
  double density(const glm::dvec3& directionWorld) const;

 private:
  BrightDirections directions_;
};

}  // namespace boxprobe
