// A capture without the lamps in it: where they show, the light of what surrounds them. For the lattice of diffuse
// light, which small bright lamps would upset, and whose lamps are drawn as shapes. CPU only.
#pragma once

#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/math/shared/lamp_math.h"

namespace boxprobe {

/// Level 0 of `capture` with every texel replaced that shows a part of a lamp, or may: by the mean of its neighbours
/// that show none, so that an unlit lamp counts as what is around it does. `lamps`: relative to the capture origin,
/// along the map's axes. `distance`: of the same capture, scene units, 0 where nothing was seen, to tell lamps behind
/// something; empty: all are seen.
CubeMap withoutLamps(const CubeMap& capture, const CubeMap& distance, const std::vector<LampPolygon>& lamps);

/// What stands in each lamp's place in such a capture, `without`: the mean over directions to the lamp. Lookups have it
/// where the lamp is, so that its shape has to give its radiance less this (withoutBackground).
std::vector<glm::vec3> lampBackgrounds(const CubeMap& without, const std::vector<LampPolygon>& lamps);

/// Radiance of a lamp's shape beside a capture with that in the lamp's place. Not below 0.
glm::vec3 withoutBackground(const glm::vec3& radiance, const glm::vec3& background);

}  // namespace boxprobe
