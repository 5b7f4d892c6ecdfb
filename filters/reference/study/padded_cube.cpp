#include "filters/reference/study/padded_cube.h"

#include <algorithm>
#include <cmath>

namespace boxprobe::study {

namespace {

// The texel beyond an edge, by folding the face's plane over it.
glm::vec4 beyondEdge(const CubeMap& cube, int level, int face, int column, int row) {
  const int size = cube.levelSize(level);
  const float step = 2.0f / static_cast<float>(size);
  const float s = -1.0f + (static_cast<float>(column) + 0.5f) * step;
  const float t = -1.0f + (static_cast<float>(row) + 0.5f) * step;
  const float beyond = std::max(std::abs(s), std::abs(t)) - 1.0f;
  const glm::vec3 edge = shading::cubeDirection(face, std::clamp(s, -1.0f, 1.0f), std::clamp(t, -1.0f, 1.0f));
  const CubePoint point = cubePoint(edge - beyond * shading::cubeDirection(face, 0.0f, 0.0f));
  const auto index = [&](float x) { return std::clamp(static_cast<int>(std::floor((x + 1.0f) / step)), 0, size - 1); };
  return cube.texel(level, point.face, index(point.s), index(point.t));
}

}  // namespace

PaddedCube::PaddedCube(const CubeMap& cube) {
  for (int level = 0; level < cube.levels(); ++level) {
    const int size = cube.levelSize(level), padded = size + 2;
    std::vector<glm::vec4> texels(6 * static_cast<std::size_t>(padded) * static_cast<std::size_t>(padded));
    for (int face = 0; face < 6; ++face) {
      const auto at = [&](int column, int row) -> glm::vec4& {
        return texels[static_cast<std::size_t>((face * padded + row + 1) * padded + column + 1)];
      };
      for (int i = 0; i < size; ++i) {
        for (int column = 0; column < size; ++column) at(column, i) = cube.texel(level, face, column, i);
        at(-1, i) = beyondEdge(cube, level, face, -1, i);
        at(size, i) = beyondEdge(cube, level, face, size, i);
        at(i, -1) = beyondEdge(cube, level, face, i, -1);
        at(i, size) = beyondEdge(cube, level, face, i, size);
      }
      for (const int column : {-1, size}) {
        for (const int row : {-1, size}) {  // three texels meet there and share the missing fourth's weight
          const int inColumn = std::clamp(column, 0, size - 1), inRow = std::clamp(row, 0, size - 1);
          at(column, row) = (at(inColumn, inRow) + at(column, inRow) + at(inColumn, row)) / 3.0f;
        }
      }
    }
    sizes_.push_back(size);
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
