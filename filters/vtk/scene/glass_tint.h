// The colour of the glass a probe sees, whatever lies behind it: what coverage, which is a number, cannot hold. Rays of
// the CPU through triangles; called once a capture, and only for scenes with glass and a light that asks.
#pragma once

#include <memory>

#include "filters/math/cube/cube_map.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

/// One level of the face size of `maps`, along its axes; null if no surface that blends has a colour. How much of the
/// light a surface lets through at all is in the coverage: this is its base colour.
std::shared_ptr<const CubeMap> glassTint(const SceneContent& content, const Probe& probe, const ProbeMaps& maps);

}  // namespace boxprobe
