#include "filters/math/cube/light_table.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

namespace {

// Rec. 709 weights; negative and infinite values count as 0.
double luminance(const glm::vec4& texel) {
  const double y = 0.2126 * static_cast<double>(texel.x) + 0.7152 * static_cast<double>(texel.y) +
                   0.0722 * static_cast<double>(texel.z);
  return std::isfinite(y) ? std::max(y, 0.0) : 0.0;
}

// Light of each cell: luminance times solid angle.
std::vector<double> cellLight(const CubeMap& radiance, int cells) {
  const int size = radiance.faceSize();
  std::vector<double> light(static_cast<std::size_t>(6 * cells * cells), 0.0);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const double s = (2.0 * column + 1.0) / size - 1.0, t = (2.0 * row + 1.0) / size - 1.0;
        const double r2 = 1.0 + s * s + t * t;
        const auto cell = static_cast<std::size_t>((face * cells + row * cells / size) * cells + column * cells / size);
        light[cell] += luminance(radiance.texel(0, face, column, row)) / (r2 * std::sqrt(r2));
      }
    }
  }
  return light;
}

}  // namespace

LightTable makeLightTable(const CubeMap& radiance) {
  LightTable table;
  if (radiance.empty()) return table;
  const int faceSize = std::min(radiance.faceSize(), LightTable::kLargestFace);
  std::vector<double> share = cellLight(radiance, faceSize);
  double sum = 0.0;
  for (const double light : share) sum += light;
  if (!(sum > 0.0)) return table;
  table.faceSize = faceSize;
  const auto count = static_cast<double>(share.size());
  // A cell covers (2 / faceSize)² of s and t.
  const double perArea = 0.25 * faceSize * faceSize / count;
  std::vector<std::size_t> few, many;
  for (std::size_t i = 0; i < share.size(); ++i) {
    share[i] *= count / sum;  // 1: as likely as the mean cell
    const auto density = static_cast<float>(share[i] * perArea);
    table.cells.emplace_back(1.0f, static_cast<float>(i), density, density);
    (share[i] < 1.0 ? few : many).push_back(i);
  }
  while (!few.empty() && !many.empty()) {
    const std::size_t cell = few.back(), other = many.back();
    few.pop_back();
    glm::vec4& entry = table.cells[cell];
    entry.x = static_cast<float>(share[cell]);
    entry.y = static_cast<float>(other);
    entry.w = table.cells[other].z;
    share[other] -= 1.0 - share[cell];
    if (share[other] >= 1.0) continue;
    many.pop_back();
    few.push_back(other);
  }
  return table;
}

}  // namespace boxprobe
