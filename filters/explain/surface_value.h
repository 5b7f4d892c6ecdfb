// What a view of the surfaces shows of one pixel, from its explanation: the same number that
// shaders/gpu/surface_view.glsl writes. Called by measures, by the debug view's readout and by tests; knows no GL.
#pragma once

#include <optional>

#include "filters/core/scene/surface_view.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// The value in the row's unit; nothing where it is not defined (background, no probe at the pixel).
std::optional<glm::vec3> surfaceValue(const SurfaceViewRow& row, const Explanation& explanation);

}  // namespace boxprobe
