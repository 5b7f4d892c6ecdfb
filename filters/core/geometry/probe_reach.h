// How far beyond its box a probe's nodes stand: as far as its influence has surfaces, in a doorway and in the rooms
// beyond that it lights. Called where lattices are derived and shadows traced; plain values.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "filters/core/geometry/sight_lines.h"

namespace boxprobe {

/// In metreOf() the box: what is farther from it is behind a wall, or through an opening in one.
inline constexpr double kWallThickness = 0.4;

/// Beyond the box's sides, along its axes, scene units, each at least 0.
struct ProbeReach {
  glm::dvec3 low{0.0}, high{0.0};
  bool none() const { return low == glm::dvec3(0.0) && high == glm::dvec3(0.0); }
  bool operator==(const ProbeReach& o) const { return low == o.low && high == o.high; }
};

/// As far as the influence goes beyond the box; nothing where that is no more than what keeps a wall's own surface
/// inside (up to 0.12). All in one frame along the box's axes, scene units.
ProbeReach influenceReach(const glm::dvec3& boxMin, const glm::dvec3& boxMax, const glm::dvec3& influenceMin,
                          const glm::dvec3& influenceMax);

/// The part of it where there are surfaces. Of up to a wall's thickness (0.4) nothing at sides without an opening:
/// those through which hardly a ray straight outwards comes so far. Where nodes would stand too far from each other for
/// the box itself, it is less, at both ends of an axis by the same share: with the box it is at most five times as long
/// as the box's shortest side, or a quarter longer than the box. `low`, `high`: the box, relative to `originWorld`,
/// along its axes.
ProbeReach openReach(const ProbeReach& asked, const SightLines& lines, const glm::dvec3& originWorld,
                     const glm::dmat3& worldFromBox, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace boxprobe
