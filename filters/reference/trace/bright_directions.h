// Directions towards the parts of a probe's capture that are much brighter than its mean, for sampling: otherwise it
// would take thousands of rays to meet a small lamp. Grouped by a few degrees, so that a surface can weight groups by
// what it reflects of each.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class BrightDirections {
 public:
  /// Reads level 0.
  explicit BrightDirections(const CubeMap& radiance);

  /// The bright part of a radiance: the excess over a cap of its largest component, with the same hue.
  glm::dvec3 excess(const glm::dvec3& radiance) const;

  /// Groups with bright light; none if nothing is above the cap.
  std::size_t groups() const { return groups_.size(); }
  /// Share of the bright light; all groups sum to 1.
  double share(std::size_t group) const { return groups_[group].share; }
  /// Not unit.
  glm::dvec3 middle(std::size_t group) const { return groups_[group].middle; }

  /// Draws a direction (not unit) in a group from two numbers in [0, 1).
  glm::dvec3 sample(std::size_t group, const glm::dvec2& u) const;

  struct Place {
    std::size_t group = 0;
    double density = 0.0;  ///< density of sample() of that group per solid angle; 0: no group contains it
  };
  /// `direction` from the capture origin, not 0.
  Place at(const glm::dvec3& direction) const;

 private:
  static constexpr int kMostCells = 128;    ///< along a side of each face
  static constexpr int kGroupsAcross = 16;  ///< along a side of each face

  struct Group {
    double share = 0.0;
    glm::dvec3 middle{0.0};
    std::size_t square = 0;         ///< index of its square of the faces, as in groupOf_
    std::vector<double> cumulated;  ///< cumulative shares of its cells, the last 1
  };

  int cells_ = 0;   ///< along a side of each face
  int across_ = 0;  ///< cells along a side of a group
  double cap_ = 0.0;
  std::vector<Group> groups_;
  std::vector<int> groupOf_;  ///< per square of the faces, face by face, row by row; -1: none
};

}  // namespace boxprobe
