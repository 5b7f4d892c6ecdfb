// Whether a lamp's light on an object can show at all, by the object's bounds, so that draws leave out those whose does
// not. Plain values; knows neither VTK nor files.
#pragma once

#include "filters/core/geometry/scene_lamps.h"

namespace boxprobe {

/// False if nowhere in `box` (world) a white surface of that roughness or more sends up `least` or more of the lamp's
/// light, diffuse or glossy: the lamp turns away from all of it, or is too faint at its distance. A bound: true may be
/// wrong. A box that is empty may be anywhere.
bool lampReaches(const SceneLamp& lamp, const Box& box, double roughness, double least);

}  // namespace boxprobe
