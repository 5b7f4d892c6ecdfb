// The translation unit that compiles shaders/shared/planar_mirror.glsl as C++.
#include "filters/math/shared/mirror_math.h"

#include <algorithm>
#include <cmath>

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

namespace {

using Values = std::vector<glm::vec4> MirrorTexels::Level::*;

// Bilinear, transparent black beyond the edges.
glm::vec4 bilinear(const MirrorTexels::Level& level, Values values, const vec2& place) {
  const float u = place.x * static_cast<float>(level.width) - 0.5f;
  const float v = place.y * static_cast<float>(level.height) - 0.5f;
  // Far outside, where the conversion to integers overflows.
  if (!(u > -2.0f && v > -2.0f && u < static_cast<float>(level.width) + 1.0f &&
        v < static_cast<float>(level.height) + 1.0f)) {
    return glm::vec4(0.0f);
  }
  const float column = std::floor(u), row = std::floor(v), a = u - column, b = v - row;
  const int i = static_cast<int>(column), j = static_cast<int>(row);
  const auto texel = [&](int x, int y) {
    const bool inside = x >= 0 && y >= 0 && x < level.width && y < level.height;
    return inside ? (level.*values)[static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
                                    static_cast<std::size_t>(x)]
                  : glm::vec4(0.0f);
  };
  return (1.0f - b) * ((1.0f - a) * texel(i, j) + a * texel(i + 1, j)) +
         b * ((1.0f - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
}

glm::vec4 trilinear(const MirrorTexels* picture, Values values, const vec2& place, float level) {
  if (picture == nullptr || picture->levels.empty()) return glm::vec4(0.0f);
  const float most = static_cast<float>(picture->levels.size() - 1);
  const float l = std::clamp(level, 0.0f, most), below = std::floor(l);
  const auto first = static_cast<std::size_t>(below);
  const glm::vec4 value = bilinear(picture->levels[first], values, place);
  if (l == below) return value;
  return glm::mix(value, bilinear(picture->levels[first + 1], values, place), l - below);
}

glm::vec4 fetchMirrorColor(const MirrorLook& look, const vec2& place, float level) {
  return trilinear(look.picture, &MirrorTexels::Level::color, place, level);
}

glm::vec4 fetchMirrorHeight(const MirrorLook& look, const vec2& place, float level) {
  return trilinear(look.picture, &MirrorTexels::Level::heights, place, level);
}

}  // namespace

#include "shaders/shared/planar_mirror.glsl"

}  // namespace boxprobe::shading
