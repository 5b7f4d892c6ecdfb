// shaders/shared/coverage.glsl and open_lookup.glsl as C++: a light's shadow, and the sky through openings.
#pragma once

#include "filters/math/shared/shared_math.h"

namespace boxprobe::shading {

#include "shaders/shared/coverage_types.glsl"

float coverageLevel(vec3 hit, vec3 factors, vec3 toLight, float tangent, float faceSize);
CoverageLook coverageLook(vec3 from, vec3 toLight, vec3 boxMin, vec3 boxMax, float tangent, float perUnit,
                          float faceSize);
vec4 openLookup(ProbeShape probe, vec3 position, vec3 direction, float level, float alpha);

}  // namespace boxprobe::shading
