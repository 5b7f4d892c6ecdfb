// A better place for the capture origin, with the box for it. Called by fit_probe.
#pragma once

#include "filters/fit/box/fit_box.h"

namespace boxprobe {

/// What is wrong with a probe, degrees: the mean lookup error of all rays, those whose end the origin does not see
/// counted as far off; and by how many levels the captured texels are too coarse for what the eyes see of them.
double originCost(const FitPlace& place, const ReflectedRays& reflected, const Probe& probe);

/// fitBox() from the best of many origins, measured by originCost: where the probe is, free places in the room, and for
/// each large mirror the middle of its eyes and of what they see of it, put close before the mirror. An origin keeps
/// 15 cm from surfaces, less in small places and before a mirror. Without a gain the origin stays. Nothing, if
/// `progress` stopped it.
std::optional<BoxFit> proposeOrigin(const FitPlace& place, const Probe& probe, const BoxFitSettings& settings = {},
                                    const FitProgress& progress = {});

}  // namespace boxprobe
