// The translation unit that compiles shaders/shared/refraction.glsl as C++.
#include "filters/math/shared/refraction.h"

#include "filters/math/shared/glsl_built_ins.h"

#define GLASS_SHELL GlassShellMap

namespace boxprobe::shading {

static vec4 fetchGlassShell(GlassShellMap shell, vec3 direction) {
  return shell != nullptr ? shell->fetchShell(direction) : vec4(0.0f);
}

#include "shaders/shared/refraction.glsl"

}  // namespace boxprobe::shading
