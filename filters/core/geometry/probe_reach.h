// How far beyond its box a probe's nodes stand: in a doorway, where its influence goes on through an opening in the
// box's side, there are nodes as well. Called where lattices are derived and shadows traced; plain values.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "filters/core/geometry/sight_lines.h"

namespace boxprobe {

/// Beyond the box's sides, along its axes, scene units, each at least 0.
struct ProbeReach {
  glm::dvec3 low{0.0}, high{0.0};
  bool none() const { return low == glm::dvec3(0.0) && high == glm::dvec3(0.0); }
  bool operator==(const ProbeReach& o) const { return low == o.low && high == o.high; }
};

/// As far as the influence goes beyond the box; nothing where that is no more than what keeps a wall's own surface
/// inside (up to 0.12), nor where it is more than a wall's thickness (0.4), and meant for what stands outside. All in
/// one frame along the box's axes, scene units.
ProbeReach influenceReach(const glm::dvec3& boxMin, const glm::dvec3& boxMax, const glm::dvec3& influenceMin,
                          const glm::dvec3& influenceMax);

/// The same, but nothing at sides without an opening: those through which hardly a ray straight outwards comes so far.
/// `low`, `high`: the box, relative to `originWorld`, along its axes.
ProbeReach openReach(const ProbeReach& asked, const SightLines& lines, const glm::dvec3& originWorld,
                     const glm::dmat3& worldFromBox, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace boxprobe
