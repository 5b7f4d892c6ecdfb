// See published_math.h. The only translation unit that compiles shaders/published.
#include "filters/math/published/published_math.h"

#include <cmath>

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

#include "shaders/published/blend.glsl"
#include "shaders/published/box_half.glsl"  // after box_select.glsl, which it uses
#include "shaders/published/box_max.glsl"
#include "shaders/published/box_select.glsl"
#include "shaders/published/box_world.glsl"  // after box_max.glsl, which it uses
#include "shaders/published/distance_ratio.glsl"
#include "shaders/published/footprint_scale.glsl"
#include "shaders/published/ggx.glsl"
#include "shaders/published/rounded_box.glsl"  // as well
#include "shaders/published/sphere.glsl"
#include "shaders/published/split_sum.glsl"

vec2 publishedSplitSum(float cosine, float roughness) {
  constexpr int kSamples = 256;
  vec2 sum(0.0f);
  for (int i = 0; i < kSamples; ++i) {
    // A golden-ratio lattice: evenly distributed in both dimensions.
    const double turn = (i + 0.5) * 0.6180339887498949;
    const vec2 u(static_cast<float>(turn - std::floor(turn)), (static_cast<float>(i) + 0.5f) / kSamples);
    sum += publishedSplitSumSample(ggxHalfVector(u, roughness * roughness), cosine, roughness * roughness);
  }
  return sum / static_cast<float>(kSamples);
}

}  // namespace boxprobe::shading
