// GLSL's built-ins are GLM's, as in shared_math.cpp.
#include "filters/math/shared/refraction.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#define GLASS_SHELL GlassShellMap

namespace boxprobe::shading {

using glm::abs;
using glm::clamp;
using glm::dot;
using glm::length;
using glm::max;
using glm::min;
using glm::pow;
using glm::sqrt;

static vec4 fetchGlassShell(GlassShellMap shell, vec3 direction) {
  return shell != nullptr ? shell->fetchShell(direction) : vec4(0.0f);
}

#include "shaders/shared/refraction.glsl"

}  // namespace boxprobe::shading
