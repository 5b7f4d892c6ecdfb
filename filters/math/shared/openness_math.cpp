// The translation unit that compiles shaders/shared/sky_openness.glsl as C++.
#include "filters/math/shared/openness_math.h"

#include <glm/geometric.hpp>

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

using glm::vec3;
using glm::vec4;

#include "shaders/shared/sky_openness.glsl"

}  // namespace boxprobe::shading
