// How probes divide a point, or an object, between them and the sky: the arithmetic of shaders/shared/weights.glsl over
// whole lists. Called where an object's probes are chosen and where a pixel is explained.
#pragma once

#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

struct ProbeShares {
  std::vector<float> probes;  ///< in the order of the weights
  float sky = 1.0f;
};

/// `groups`: of equal importance, ascending from 0 as importance falls. `onlyProbes`: what is left for the sky goes to
/// the probes in proportion, wherever one has any weight.
ProbeShares shareOut(const std::vector<float>& weights, const std::vector<int>& groups, bool onlyProbes);

/// One weight for all of an object: the share of its bounds that the influence box holds, along each of the box's axes
/// and multiplied. Continuous as either moves; 1 for what lies inside.
double objectWeight(const Probe& probe, const Box& boundsWorld);

}  // namespace boxprobe
