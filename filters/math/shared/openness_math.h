// shaders/shared/sky_openness.glsl as C++: how much of the sky a surface sees past what stands around it. The
// definitions are in openness_math.cpp.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace boxprobe::shading {

/// Share of the light of an even sky that what faces `normal` (unit) gets, 0 to 1. `texel`: 0 to 1 each.
float skyOpenness(glm::vec4 texel, glm::vec3 normal);
/// The same of what it reflects; `open` is that of its diffuse light.
float reflectedOpenness(float open, float nDotV, float roughness);

}  // namespace boxprobe::shading
