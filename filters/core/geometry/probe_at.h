// Which probe lights a place.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// The probe with the largest share of the light reflected at `pointWorld`; among equal shares the one with the smaller
/// influence box. Nothing where no probe has any weight and the sky lights the place.
std::optional<std::size_t> probeLighting(const std::vector<Probe>& probes, const glm::dvec3& pointWorld);

/// The same, but where none has any weight the probe whose influence box is nearest. Nothing without probes.
std::optional<std::size_t> probeNearest(const std::vector<Probe>& probes, const glm::dvec3& pointWorld);

}  // namespace boxprobe
