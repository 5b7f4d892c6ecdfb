// The value that a view of the surfaces shows for one pixel, from its explanation: the same number as in
// shaders/gpu/surface_view.glsl.
#pragma once

#include <optional>

#include "filters/core/scene/surface_view.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// In the row's unit; nothing where it is undefined (background, no probe at the pixel).
std::optional<glm::vec3> surfaceValue(const SurfaceViewRow& row, const Explanation& explanation);

}  // namespace boxprobe
