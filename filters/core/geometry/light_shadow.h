// Which lights a probe's coverage stands before, and how large they look: the same answers for what is drawn, explained
// and remarked on. Plain values.
#pragma once

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Does the light shine into the probe's box from outside of it? Directional ones always do.
bool lightOutside(const Light& light, const Probe& probe);

/// A light's size: `tangent` of half its angle plus `radius` over the distance to it.
struct LightSize {
  float tangent = 0.0f;
  float radius = 0.0f;
  float tangentAt(float distance) const;
};
LightSize lightSize(const Light& light);

/// Levels a unit of ShadowLevel::Distance as published: all of a chain over the longest distance in the box.
float levelsPerUnit(const glm::vec3& boxMin, const glm::vec3& boxMax, float maxLevel);

/// Probes have a bit for each of so many lights.
constexpr std::size_t kMostShadowLights = 31;

}  // namespace boxprobe
