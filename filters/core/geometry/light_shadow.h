// Which lights a probe's coverage can shadow, and how large they appear: shared by drawing, explanations and remarks.
#pragma once

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Does the light shine into the probe's box from outside? Directional lights always do.
bool lightOutside(const Light& light, const Probe& probe);

/// The apparent size of a light: `tangent` of half its angle plus `radius` over the distance to it.
struct LightSize {
  float tangent = 0.0f;
  float radius = 0.0f;
  float tangentAt(float distance) const;
};
LightSize lightSize(const Light& light);

/// Levels per unit for ShadowLevel::Distance, as published: the whole chain over the longest distance in the box.
float levelsPerUnit(const glm::vec3& boxMin, const glm::vec3& boxMax, float maxLevel);

/// Lights that can cast such shadows: a probe has one bit for each.
constexpr std::size_t kMostShadowLights = 31;

}  // namespace boxprobe
