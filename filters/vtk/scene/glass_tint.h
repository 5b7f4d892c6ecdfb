// The colour of the glass that a probe sees, which coverage, a single number, cannot hold. Traced on the CPU once per
// capture, only for scenes with glass and a light that casts coverage shadows.
#pragma once

#include <memory>

#include "filters/math/cube/cube_map.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

/// One level with the face size of `maps`, along its axes; null if no blended surface has a colour. It holds the base
/// colour; the coverage holds how much light a surface transmits.
std::shared_ptr<const CubeMap> glassTint(const SceneContent& content, const Probe& probe, const ProbeMaps& maps);

}  // namespace boxprobe
