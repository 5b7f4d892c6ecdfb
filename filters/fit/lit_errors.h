// The error of a place's reflections with all of its probes: each surface point samples the probes that it blends when
// drawn.
#pragma once

#include <vector>

#include "filters/fit/fit_probe.h"

namespace boxprobe {

struct LitErrors {
  double meanDegrees = 0.0;  ///< lookup error, at most 20; 20 without a probe, or where its probe does not see the end
  double p95Degrees = 0.0;
  double hidden = 0.0;  ///< share of the reflections whose end the probes there do not see
  double unlit = 0.0;   ///< share of the reflections that no probe lights
};

/// `rays` are from reflectedRays; `probes` need not be in the scene.
LitErrors litErrors(ProbeFitter& fitter, const ReflectedRays& rays, const std::vector<Probe>& probes);

}  // namespace boxprobe
