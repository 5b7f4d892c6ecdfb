// Diffuse light of lamps and lattices as functions for another program, from the shader files that this program draws
// with: what techniqueText() adds to a technique.
#pragma once

#include <string>
#include <vector>

#include "filters/core/geometry/scene_lamps.h"

namespace boxprobe {

/// GLSL, before the preprocessor: `boxprobeLattice(...)`, irradiance over pi from a lattice that an exported .glb
/// holds, and of the lamps `boxprobeLamp(i)` and `boxprobeLampDiffuse(lamp, position, normal)`. World space, scene
/// units. Needs BoxprobeProbe and LAMP_SLOT defined as BoxprobeLamp.
std::string lightText(const std::vector<SceneLamp>& lamps);

}  // namespace boxprobe
