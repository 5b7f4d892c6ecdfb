// See published_math.h. The only translation unit that compiles shaders/published.
#include "filters/math/published/published_math.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace boxprobe::shading {

using glm::abs;
using glm::clamp;
using glm::dot;
using glm::length;
using glm::max;
using glm::min;
using glm::mix;
using glm::sqrt;

#include "shaders/published/blend.glsl"
#include "shaders/published/box_max.glsl"
#include "shaders/published/box_select.glsl"
#include "shaders/published/box_world.glsl"  // after box_max.glsl, which it uses
#include "shaders/published/distance_ratio.glsl"
#include "shaders/published/footprint_scale.glsl"
#include "shaders/published/ggx.glsl"
#include "shaders/published/rounded_box.glsl"  // as well
#include "shaders/published/sphere.glsl"

}  // namespace boxprobe::shading
