// Sight lines among the triangles of a scene (Embree): what lamps' shadows are traced in. Programs that link this
// library hand traceSightLines to the scene renderer.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/geometry/sight_lines.h"

namespace boxprobe {

/// Visible objects that are not marked `dynamic`. Not glass, nor what blends, nor a dome with a painted sky. `models`
/// in the order of scene.models. Throws WorkError where the ray tracer cannot take them.
std::shared_ptr<const SightLines> traceSightLines(const Scene& scene,
                                                  const std::vector<std::shared_ptr<const Model>>& models);

}  // namespace boxprobe
