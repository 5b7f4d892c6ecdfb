// shaders/shared/refraction.glsl as C++: one source for glass in pictures and in explanations. The definitions are in
// refraction.cpp.
#pragma once

#include "filters/math/shared/shared_math.h"

namespace boxprobe::shading {

/// A glass object's shell; implements `fetchGlassShell` in C++.
class ShellSampler {
 public:
  virtual ~ShellSampler() = default;
  /// The plane of the surface seen from the centre along `direction`, which need not be unit: outward normal and
  /// distance from the centre; bilinear.
  virtual glm::vec4 fetchShell(const glm::vec3& direction) const = 0;
};
using GlassShellMap = const ShellSampler*;

#define GLASS_SHELL GlassShellMap
#include "shaders/shared/glass_types.glsl"
#undef GLASS_SHELL

float dielectricReflectance(float cosine, float eta);
float sheetReflectance(float reflectance);
vec3 refractedView(vec3 normal, vec3 view, float eta);
float refractionSpread(float cosine, float far, float eta);
vec3 glassTransmittance(vec3 color, float reach, float distance);
vec4 shellExit(GlassShellMap shell, GlassObject glass, vec3 position, vec3 direction);
GlassView lookThroughGlass(GlassShellMap shell, GlassObject glass, vec3 position, vec3 normal, vec3 view,
                           float roughness, bool back, float eye);
float glassDeviation(GlassObject glass, GlassRay ray, vec3 position, vec3 view);

}  // namespace boxprobe::shading
