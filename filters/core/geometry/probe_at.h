// Which probe lights a place. Called by the window: a click, and where one stands, select a probe.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// The probe with the largest share of the light reflected at `pointWorld`; of equal shares the smaller influence box.
/// Nothing where no probe has any weight: the sky lights that place.
std::optional<std::size_t> probeLighting(const std::vector<Probe>& probes, const glm::dvec3& pointWorld);

/// The same; where none has any weight, the probe whose influence box is nearest. Nothing without probes.
std::optional<std::size_t> probeNearest(const std::vector<Probe>& probes, const glm::dvec3& pointWorld);

}  // namespace boxprobe
