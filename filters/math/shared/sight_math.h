// shaders/shared/sight.glsl as C++: where a surface looks up what it sees of its lamps. The definition is in
// sight_math.cpp.
#pragma once

#include "filters/math/shared/lamp_math.h"

namespace boxprobe::shading {

/// A lattice of visibilities as the mathematics sees it.
class SightSampler {
 public:
  virtual ~SightSampler() = default;
  /// Shares, 0 to 1, of lamps 4 `part` to 4 `part` + 3; linear between nodes. `place`: number of the node along each
  /// axis, within them.
  virtual glm::vec4 fetchSight(const glm::vec3& place, int part) const = 0;
};

/// The lattice's slot is not used.
vec3 sightPlace(LatticeShape lattice, vec3 position, vec3 n);
/// `share`: of a channel; `say`: of channel 0.
float sightShare(float share, float say);

}  // namespace boxprobe::shading
