// Where a probe's capture is much brighter than its mean: directions to draw rays towards, so that a small lamp does
// not need thousands of rays before one meets it. Called by the box-world reference; knows no surface.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/math/cube_map.h"

namespace boxprobe {

class BrightDirections {
 public:
  /// From level 0.
  explicit BrightDirections(const CubeMap& radiance);

  /// False: nothing stands out, and the other functions must not be asked.
  bool any() const { return !shares_.empty(); }
  /// What of a radiance counts as bright: what exceeds `cap` of its largest component, its hue kept.
  glm::dvec3 excess(const glm::dvec3& radiance) const;

  /// A direction (not unit) by two numbers in [0, 1).
  glm::dvec3 sample(const glm::dvec2& u) const;
  /// How densely sample() draws it, per solid angle about the capture's origin; `direction` not 0.
  double density(const glm::dvec3& direction) const;

 private:
  static constexpr int kMostCells = 128;  ///< a side of each face

  int cells_ = 0;

  double cap_ = 0.0;
  std::vector<double> shares_;     ///< of each cell, face by face, row by row; sums to 1
  std::vector<double> cumulated_;  ///< before each cell
};

}  // namespace boxprobe
