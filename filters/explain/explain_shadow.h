// Recomputes the shadows on a pixel, from each light that a probe's coverage shadows, as shaders/gpu/coverage.glsl
// does.
#pragma once

#include <vector>

#include "filters/explain/explain_input.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// One entry per element of `in.shadowLights`.
std::vector<LightShadow> explainShadows(const ExplainInput& in);

/// Visibility of a lamp or light source from the surface, by its channel of the probe's sight, kSeenByAll or
/// kSeenByNone.
float seenShare(const ExplainedProbe& probe, const SurfacePoint& surface, int channel);
/// The same for a light source, weighted by all probes' shares; 1 unless it is among `in.sightLights`.
float lightSeen(const ExplainInput& in, int light);
/// Of a sun, by the maps of what stands still before it; 1 without one.
float sunSeen(const ExplainInput& in, int light);

struct ShadowRay {
  glm::vec3 toLight{0.0f};  ///< unit, world
  ProbeShadow shadow;
};
/// A ray towards a light through one probe's coverage; if that is unknown, the level is 0 and nothing passes.
ShadowRay shadowRay(const ExplainedProbe& probe, const glm::dvec3& positionWorld, const glm::dvec3& eyeWorld,
                    const Light& light);

/// The mean of nine interpolated depth comparisons with a map of moving objects: 0 in shadow, 1 lit.
float movingShadowAt(const MovingMap& map, const glm::dvec3& positionWorld);

}  // namespace boxprobe
