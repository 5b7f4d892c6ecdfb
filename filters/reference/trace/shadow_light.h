// The visible share of a light at a point, by rays towards its whole disc: through openings, and coloured by glass. The
// reference for shadows by coverage.
#pragma once

#include <glm/vec3.hpp>

#include "filters/core/scene/scene.h"
#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

/// Mean over `side`² directions (the disc of a directional light's angle, or a positional light's sphere seen as a
/// disc); 0: in shadow, 1: unobstructed. `away`: the point, off its own surface (SceneTracer::awayFrom). A blended
/// surface transmits 1 - opacity times its base colour.
glm::dvec3 lightThrough(const SceneTracer& tracer, const glm::dvec3& away, const Light& light, int side,
                        RaySees sees = RaySees::Probes);

}  // namespace boxprobe
