#include "filters/reference/study/padded_cube.h"

#include <algorithm>

#include "filters/math/cube/flat_cube.h"

namespace boxprobe::study {

PaddedCube::PaddedCube(const CubeMap& cube) {
  for (int level = 0; level < cube.levels(); ++level) {
    std::vector<glm::vec4> texels;
    for (int face = 0; face < 6; ++face) {
      const std::vector<glm::vec4> padded = paddedFace(cube, level, face);
      texels.insert(texels.end(), padded.begin(), padded.end());
    }
    sizes_.push_back(cube.levelSize(level));
    levels_.push_back(std::move(texels));
  }
}

glm::vec4 PaddedCube::tap(const CubePoint& point, std::size_t level) const {
  const int size = sizes_[level], padded = size + 2;
  const float u = (0.5f * point.s + 0.5f) * static_cast<float>(size) + 0.5f;
  const float v = (0.5f * point.t + 0.5f) * static_cast<float>(size) + 0.5f;
  const int column = std::min(static_cast<int>(u), size), row = std::min(static_cast<int>(v), size);
  const float a = u - static_cast<float>(column), b = v - static_cast<float>(row);
  const glm::vec4* p = &levels_[level][static_cast<std::size_t>((point.face * padded + row) * padded + column)];
  return (1.0f - b) * ((1.0f - a) * p[0] + a * p[1]) + b * ((1.0f - a) * p[padded] + a * p[padded + 1]);
}

glm::vec4 PaddedCube::fetch(const glm::vec3& direction, float level) const {
  const CubePoint point = cubePoint(direction);
  const float clamped = std::clamp(level, 0.0f, maxLevel());
  const auto lower = static_cast<std::size_t>(clamped);
  const float fraction = clamped - static_cast<float>(lower);
  const glm::vec4 value = tap(point, lower);
  return fraction > 0.0f ? (1.0f - fraction) * value + fraction * tap(point, lower + 1) : value;
}

}  // namespace boxprobe::study
