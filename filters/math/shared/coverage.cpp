#include "filters/math/shared/coverage.h"

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

static const float kNoHit = 3.0e38f;  // as in shaders/shared/slab.glsl

#include "shaders/shared/coverage.glsl"
#include "shaders/shared/open_lookup.glsl"

}  // namespace boxprobe::shading
