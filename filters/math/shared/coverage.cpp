#include "filters/math/shared/coverage.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace boxprobe::shading {

using glm::abs;
using glm::clamp;
using glm::dot;
using glm::length;
using glm::log2;
using glm::max;
using glm::min;
using glm::sqrt;

static const float kNoHit = 3.0e38f;  // that of shaders/shared/slab.glsl

#include "shaders/shared/coverage.glsl"
#include "shaders/shared/open_lookup.glsl"

}  // namespace boxprobe::shading
