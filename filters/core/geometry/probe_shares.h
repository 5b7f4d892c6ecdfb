// How probes and the sky share a point or an object: the arithmetic of shaders/shared/weights.glsl over whole lists.
#pragma once

#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

struct ProbeShares {
  std::vector<float> probes;  ///< in the order of the weights
  float sky = 1.0f;
};

/// `groups`: numbers of equal importance, from 0 upwards as importance falls. `onlyProbes`: the sky's share is divided
/// among the probes in proportion, wherever one has any weight.
ProbeShares shareOut(const std::vector<float>& weights, const std::vector<int>& groups, bool onlyProbes);

/// One weight for a whole object: the fraction of its bounds inside the influence box, along each of the box's axes,
/// multiplied. Continuous when either moves; 1 for what lies inside.
double objectWeight(const Probe& probe, const Box& boundsWorld);

}  // namespace boxprobe
