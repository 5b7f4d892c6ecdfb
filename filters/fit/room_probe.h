// A probe for an interior or a court, from what its origin sees.
#pragma once

#include "filters/core/scene/scene.h"
#include "filters/fit/standing_points.h"

namespace boxprobe {

/// Captured at `stand`. Each face of the box lies at the median distance of the surfaces that face the origin from its
/// side (within 45 degrees); without any, at the model's bounds. It lights the whole model.
Probe roomProbe(const TriangleRays& rays, const StandingPoint& stand);

}  // namespace boxprobe
