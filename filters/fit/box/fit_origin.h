// Finds a better capture origin, with the box for it.
#pragma once

#include "filters/fit/box/fit_box.h"

namespace boxprobe {

/// The error of a probe in degrees: the mean lookup error of all rays, with a large error for those whose end the
/// origin does not see, and the number of levels by which the captured texels are too coarse for the eyes.
double originCost(const FitPlace& place, const ReflectedRays& reflected, const Probe& probe);

/// fitBox() from the best of many origins by originCost: the probe's own, free places in the room and, for each large
/// mirror, the middle between its eyes and what they see in it, moved close to the mirror. An origin keeps 15 cm from
/// surfaces, less in small places and in front of a mirror. Without a gain the origin stays. Nothing if `progress`
/// stopped it.
std::optional<BoxFit> proposeOrigin(const FitPlace& place, const Probe& probe, const BoxFitSettings& settings = {},
                                    const FitProgress& progress = {});

}  // namespace boxprobe
