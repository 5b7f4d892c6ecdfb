// What stands between a pixel's surface and each light whose shadows a probe's coverage throws, done again on the CPU
// as shaders/gpu/coverage.glsl does it. Called by explainPixel.
#pragma once

#include <vector>

#include "filters/explain/explain_input.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// One entry for each of `in.shadowLights`.
std::vector<LightShadow> explainShadows(const ExplainInput& in);

/// What the surface sees of a lamp or light source: of a channel of the probe's sight, or kSeenByAll, kSeenByNone.
float seenShare(const ExplainedProbe& probe, const SurfacePoint& surface, int channel);
/// The same of a light source by all probes' shares; 1 of one that is not among `in.sightLights`.
float lightSeen(const ExplainInput& in, int light);
/// Of a sun, by the maps of what stands still before it; 1 without one.
float sunSeen(const ExplainInput& in, int light);

struct ShadowRay {
  glm::vec3 toLight{0.0f};  ///< unit, world
  ProbeShadow shadow;
};
/// Towards one light past one probe's coverage; its level is 0 and nothing comes through where that is not known.
ShadowRay shadowRay(const ExplainedProbe& probe, const glm::dvec3& positionWorld, const glm::dvec3& eyeWorld,
                    const Light& light);

/// Of nine interpolated comparisons with a map of what moves: 0 in its shadow, 1 out of it.
float movingShadowAt(const MovingMap& map, const glm::dvec3& positionWorld);

}  // namespace boxprobe
