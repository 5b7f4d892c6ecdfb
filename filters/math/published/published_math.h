// shaders/published compiled as C++, as shared_math.h does with the program's own shaders: formulas as published
// elsewhere, put through the same tests. No technique uses them.
#pragma once

#include "filters/math/shared/shared_math.h"

namespace boxprobe::shading {

ProbeHit publishedBoxSelect(ProbeShape probe, vec3 position, vec3 reflection);
ProbeHit publishedBoxMax(ProbeShape probe, vec3 position, vec3 reflection);
ProbeHit publishedBoxWorld(ProbeShape probe, vec3 origin, vec3 position, vec3 reflection);
ProbeHit publishedBoxHalf(ProbeShape probe, vec3 origin, vec3 position, vec3 reflection);
ProbeHit publishedRoundedBox(ProbeShape probe, vec3 position, vec3 reflection);
ProbeHit publishedSphere(ProbeShape probe, vec3 position, vec3 reflection);
float publishedDistanceRoughness(float hitDistance, vec3 lookup, float roughness);
float publishedFootprintScale(ProbeShape probe, ProbeHit hit, vec3 direction);
float publishedDistribution(float nh, float alpha);
float publishedMasking(float nv, float alpha);
/// Factors of F0 and F90 with the masking term that is printed most often; 256 samples.
vec2 publishedSplitSum(float cosine, float roughness);
float publishedInfluence(vec3 position, vec3 influenceMin, vec3 influenceMax, float blendDistance);

}  // namespace boxprobe::shading
