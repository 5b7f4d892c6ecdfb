// See published_math.h. The only translation unit that compiles shaders/published.
#include "filters/math/published/published_math.h"

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

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
