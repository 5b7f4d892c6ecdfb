// A camera for a model that has none: outside an object, inside an interior.
#pragma once

#include "filters/core/scene/scene.h"
#include "filters/fit/standing_points.h"

namespace boxprobe {

/// Camera "main" in a three-quarter view, such that `corners` (world points whose hull contains everything) fill 88 %
/// of the height, or of the width if that is smaller; `aspect` is the picture's width over height.
Camera objectCamera(const std::vector<glm::dvec3>& corners, const Box& bounds, double aspect);

/// Camera "main" at eye height, with the position and direction of the longest view that nothing close obstructs.
Camera roomCamera(const TriangleRays& rays, const std::vector<StandingPoint>& stands, double aspect);

}  // namespace boxprobe
