// How much of a light arrives at a point past what stands in its way, by rays towards all of its disc: through
// openings, and coloured by glass. What shadows by coverage are measured against. Called by tests; knows no probe and
// no GL.
#pragma once

#include <glm/vec3.hpp>

#include "filters/core/scene/scene.h"
#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

/// Mean over `side`² directions (a directional light's disc of its angle, a sphere of a positional one's radius seen as
/// a disc); 0: all in shadow, 1: nothing in the way. `away`: the point, off its own surface (SceneTracer::awayFrom).
/// A surface that blends lets 1 - opacity times its base colour through.
glm::dvec3 lightThrough(const SceneTracer& tracer, const glm::dvec3& away, const Light& light, int side,
                        RaySees sees = RaySees::Probes);

}  // namespace boxprobe
