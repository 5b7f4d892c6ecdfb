#include "filters/math/sampling/brdf_table.h"

#include <algorithm>
#include <cmath>

#include "filters/math/shared/shared_math.h"

namespace boxprobe {

namespace {

constexpr int kLast = kBrdfTableSize - 1;

}  // namespace

// Written by write_brdf_table.cpp.
const std::uint16_t kBrdfTable[] = {
#include "brdf_table.inc"
};

glm::vec2 splitSum(float nDotV, float roughness) {
  const auto texel = [](int column, int row) {
    const int at = 2 * (std::clamp(row, 0, kLast) * kBrdfTableSize + std::clamp(column, 0, kLast));
    return glm::vec2(kBrdfTable[at], kBrdfTable[at + 1]) / 65535.0f;
  };
  const glm::vec2 place =
      shading::splitSumPlace(nDotV, roughness, kBrdfTableSize) * static_cast<float>(kBrdfTableSize) - glm::vec2(0.5f);
  const float column = std::floor(place.x), row = std::floor(place.y);
  const float a = place.x - column, b = place.y - row;
  const int i = static_cast<int>(column), j = static_cast<int>(row);
  return (1.0f - b) * ((1.0f - a) * texel(i, j) + a * texel(i + 1, j)) +
         b * ((1.0f - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
}

}  // namespace boxprobe
