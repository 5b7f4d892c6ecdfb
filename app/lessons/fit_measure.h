// A number of a box fit, by the name that `boxprobe fit --json` gives it: what lessons on fitting measure. Called by
// lesson_measure.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// `pointer`: as in "/probes/0/faces/+x/gainDegrees", "/probes/0/before/meanDegrees", "/probes/0/box/max/0". Fits that
/// probe's box afresh, with its origin where it is. Nothing if there is no such probe or number, or `goOn` said no.
/// Throws WorkError where the ray tracer cannot take the models.
std::optional<double> fitNumber(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                                const std::string& pointer, const std::function<bool()>& goOn);

}  // namespace boxprobe
