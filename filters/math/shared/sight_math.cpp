// The translation unit that compiles shaders/shared/sight.glsl as C++.
#include "filters/math/shared/sight_math.h"

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

#include "shaders/shared/sight.glsl"

}  // namespace boxprobe::shading
