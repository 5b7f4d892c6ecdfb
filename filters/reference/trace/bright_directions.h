// Where a probe's capture is much brighter than its mean: directions to draw rays towards, so that a small lamp does
// not need thousands of rays before one meets it. In groups of a few degrees, so that a surface can weigh them by what
// it reflects of each. Called by the box-world reference; knows no surface.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class BrightDirections {
 public:
  /// From level 0.
  explicit BrightDirections(const CubeMap& radiance);

  /// What of a radiance counts as bright: what exceeds a cap of its largest component, its hue kept.
  glm::dvec3 excess(const glm::dvec3& radiance) const;

  /// Some light in each; none where nothing stands out.
  std::size_t groups() const { return groups_.size(); }
  /// Of the light that stands out; over all groups 1.
  double share(std::size_t group) const { return groups_[group].share; }
  /// Not unit.
  glm::dvec3 middle(std::size_t group) const { return groups_[group].middle; }

  /// A direction (not unit) in a group, by two numbers in [0, 1).
  glm::dvec3 sample(std::size_t group, const glm::dvec2& u) const;

  struct Place {
    std::size_t group = 0;
    double density = 0.0;  ///< how densely sample() of that group draws it, per solid angle; 0: no group does
  };
  /// `direction` about the capture's origin, not 0.
  Place at(const glm::dvec3& direction) const;

 private:
  static constexpr int kMostCells = 128;    ///< a side of each face
  static constexpr int kGroupsAcross = 16;  ///< a side of each face

  struct Group {
    double share = 0.0;
    glm::dvec3 middle{0.0};
    std::size_t square = 0;         ///< its square of the faces, as in groupOf_
    std::vector<double> cumulated;  ///< shares of its cells within it, summed up, the last 1
  };

  int cells_ = 0;   ///< a side of each face
  int across_ = 0;  ///< cells along a side of a group
  double cap_ = 0.0;
  std::vector<Group> groups_;
  std::vector<int> groupOf_;  ///< of each square of the faces, face by face, row by row; -1: none
};

}  // namespace boxprobe
