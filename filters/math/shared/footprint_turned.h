// shaders/shared/footprint_turned.glsl for who fits its constants; techniques call it in the shader files themselves.
#pragma once

#include "filters/math/shared/shared_math.h"

namespace boxprobe::shading {

vec3 footprintAxes(ProbeShape probe, ShadingPoint point, FootprintLobe lobe);
vec4 footprintPowers(ShadingPoint point);
float footprintConstant(FootprintLobe lobe, vec3 axes, vec4 powers, vec4 constants, vec3 byAxes, vec3 byView);
float footprintTurnedSize(vec3 axes, float size, float narrowing);
FootprintSum footprintAddTurned(ProbeMap map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, vec3 axes,
                                FootprintSum sum, float x, float y, float weight, float size, float nearer);

}  // namespace boxprobe::shading
