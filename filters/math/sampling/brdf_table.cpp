#include "filters/math/sampling/brdf_table.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include "filters/math/shared/shared_math.h"

namespace boxprobe {

glm::vec2 integrateBrdf(float cosine, float roughness, int samples) {
  const float alpha = roughness * roughness;
  const float k = 0.5f * alpha;
  const auto masking = [k](float c) { return c / (c * (1.0f - k) + k); };
  const glm::vec3 view(std::sqrt(std::max(1.0f - cosine * cosine, 0.0f)), 0.0f, cosine);
  glm::vec2 sum(0.0f);
  for (int i = 0; i < samples; ++i) {
    // Golden-ratio lattice: even in both dimensions for any count.
    const float u = static_cast<float>(std::fmod((i + 0.5) * 0.6180339887498949, 1.0));
    const glm::vec3 half = shading::ggxHalfVector(glm::vec2(u, (i + 0.5f) / samples), alpha);
    const float viewHalf = glm::dot(view, half);
    const glm::vec3 light = 2.0f * viewHalf * half - view;
    if (light.z <= 0.0f || viewHalf <= 0.0f) continue;
    const float visible = masking(cosine) * masking(light.z) * viewHalf / (half.z * cosine);
    const float fresnel = std::pow(1.0f - std::min(viewHalf, 1.0f), 5.0f);
    sum += glm::vec2((1.0f - fresnel) * visible, fresnel * visible);
  }
  return sum / static_cast<float>(samples);
}

BrdfTable makeBrdfTable(int columns, int rows, int samples) {
  BrdfTable table{columns, rows, {}};
  table.texels.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      table.texels.push_back(integrateBrdf((static_cast<float>(column) + 0.5f) / static_cast<float>(columns),
                                           (static_cast<float>(row) + 0.5f) / static_cast<float>(rows), samples));
    }
  }
  return table;
}

glm::vec2 sampleBrdf(const BrdfTable& table, float nDotV, float roughness) {
  const auto texel = [&](int column, int row) {
    const glm::vec2 t = table.texels[static_cast<std::size_t>(std::clamp(row, 0, table.rows - 1) * table.columns +
                                                              std::clamp(column, 0, table.columns - 1))];
    return glm::vec2(glm::unpackHalf1x16(glm::packHalf1x16(t.x)), glm::unpackHalf1x16(glm::packHalf1x16(t.y)));
  };
  const float u = nDotV * static_cast<float>(table.columns) - 0.5f,
              v = roughness * static_cast<float>(table.rows) - 0.5f;
  const float column = std::floor(u), row = std::floor(v);
  const float a = u - column, b = v - row;
  const int i = static_cast<int>(column), j = static_cast<int>(row);
  return (1.0f - b) * ((1.0f - a) * texel(i, j) + a * texel(i + 1, j)) +
         b * ((1.0f - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
}

}  // namespace boxprobe
