// How wrong the reflections of a place are with all of its probes: each surface point looks up what its probes share,
// as it is drawn. Called by place_probes, which chooses by it, and by its report.
#pragma once

#include <vector>

#include "filters/fit/fit_probe.h"

namespace boxprobe {

struct LitErrors {
  double meanDegrees =
      0.0;  ///< lookup error, at most 20; what no probe lights and what its probe does not see counts 20
  double p95Degrees = 0.0;
  double hidden = 0.0;  ///< share of the reflections whose end the probes that light them do not see
  double unlit = 0.0;   ///< share of the reflections that no probe lights
};

/// Of rays by reflectedRays; `probes` need not be in the scene.
LitErrors litErrors(ProbeFitter& fitter, const ReflectedRays& rays, const std::vector<Probe>& probes);

}  // namespace boxprobe
