// The soft shadow that everything in a scene casts on a plane below it: how much of an even sky's light a place of the
// plane is left. Traced once for a scene as it stands still; drawn under models that have no ground of their own.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "filters/core/geometry/sight_lines.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

struct GroundShadow {
  double height = 0.0;             ///< world y of the plane
  glm::dvec2 low{0.0}, high{0.0};  ///< world x and z of its edges
  int columns = 0, rows = 0;       ///< along x, along z
  std::vector<float> light;        ///< row after row from low z: 0 hidden from all of the sky, 1 lit by all of it

  bool empty() const { return light.empty(); }
};

/// Of what stands in `bounds` (world), which lies just above the plane; empty where nothing does or `stop` said true.
/// The plane reaches as far beyond the bounds as their longest side, where the shadow has faded away.
GroundShadow tracedGroundShadow(const SightLines& lines, const Box& bounds, const std::function<bool()>& stop = {});

}  // namespace boxprobe
