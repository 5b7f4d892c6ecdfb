// A camera for a model that has none: outside of an object, within an interior. Called by fit_model.
#pragma once

#include "filters/core/scene/scene.h"
#include "filters/fit/standing_points.h"

namespace boxprobe {

/// Camera "main" at a three-quarter view, such that `corners` (world points whose hull holds all) fill 88 % of the
/// height, or of the width where that is less; `aspect` is the picture's width over height.
Camera objectCamera(const std::vector<glm::dvec3>& corners, const Box& bounds, double aspect);

/// Camera "main" at eye height, where and towards where the view is longest and nothing stands close before it.
Camera roomCamera(const TriangleRays& rays, const std::vector<StandingPoint>& stands, double aspect);

}  // namespace boxprobe
