// See other_maps.h.
#include "app/lessons/other_maps.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace boxprobe {

namespace {

float texelMiddle(int index, int size) {
  return (2.0f * static_cast<float>(index) + 1.0f) / static_cast<float>(size) - 1.0f;
}

glm::vec4 nearestTexel(const CubeMap& cube, int level, const glm::vec3& direction) {
  const int size = cube.levelSize(level);
  const CubePoint point = cubePoint(direction);
  const auto index = [size](float x) {
    return std::clamp(static_cast<int>(std::floor(0.5f * (x + 1.0f) * static_cast<float>(size))), 0, size - 1);
  };
  return cube.texel(level, point.face, index(point.s), index(point.t));
}

glm::vec4 levelWithinFace(const CubeMap& cube, const CubePoint& point, int level) {
  const int size = cube.levelSize(level);
  const auto last = static_cast<float>(size - 1);
  const float u = std::clamp(0.5f * (point.s + 1.0f) * static_cast<float>(size) - 0.5f, 0.0f, last);
  const float v = std::clamp(0.5f * (point.t + 1.0f) * static_cast<float>(size) - 0.5f, 0.0f, last);
  const int column = std::min(static_cast<int>(u), std::max(size - 2, 0));
  const int row = std::min(static_cast<int>(v), std::max(size - 2, 0));
  const int right = std::min(column + 1, size - 1), below = std::min(row + 1, size - 1);
  const float a = u - static_cast<float>(column), b = v - static_cast<float>(row);
  const auto at = [&](int x, int y) { return cube.texel(level, point.face, x, y); };
  return glm::mix(glm::mix(at(column, row), at(right, row), a), glm::mix(at(column, below), at(right, below), a), b);
}

/// What is added to the texel for one edge of its face. `alongT`: the edge t = side.
glm::vec4 pullOverEdge(const CubeMap& cube, int level, int face, const glm::ivec2& texel, bool alongT) {
  const int size = cube.levelSize(level);
  const float s = texelMiddle(texel.x, size), t = texelMiddle(texel.y, size);
  const float side = (alongT ? t : s) < 0.0f ? -1.0f : 1.0f;
  const glm::vec3 across = shading::directionAcrossEdge(face, side, alongT ? s : t, alongT, static_cast<float>(size));
  const int edge = side < 0.0f ? 0 : size - 1;
  const glm::vec4 here = alongT ? cube.texel(level, face, texel.x, edge) : cube.texel(level, face, edge, texel.y);
  return nearestTexel(cube, level, across) - here;
}

}  // namespace

CubeMap withPlainMeans(const CubeMap& cube) {
  CubeMap made = cube;
  for (int level = 1; level < made.levels(); ++level) {
    const int size = made.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          glm::vec4 sum(0.0f);
          for (int i = 0; i < 4; ++i) sum += made.texel(level - 1, face, 2 * column + i % 2, 2 * row + i / 2);
          made.setTexel(level, face, column, row, 0.25f * sum);
        }
      }
    }
  }
  return made;
}

CubeMap withEdgeFixup(const CubeMap& cube, int width) {
  CubeMap made = cube;
  for (int level = 1; level < cube.levels(); ++level) {
    const int size = cube.levelSize(level);
    const auto reach = static_cast<float>(std::min(width, size / 2));
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          const auto fromEdge = [size](int i) { return static_cast<float>(std::min(i, size - 1 - i)); };
          const float shareS = shading::edgeFixupShare(fromEdge(column), reach);
          const float shareT = shading::edgeFixupShare(fromEdge(row), reach);
          glm::vec4 value = cube.texel(level, face, column, row);
          const float pullS = shading::edgeFixupPull(shareS, shareT), pullT = shading::edgeFixupPull(shareT, shareS);
          if (pullS > 0.0f) value += pullS * pullOverEdge(cube, level, face, {column, row}, false);
          if (pullT > 0.0f) value += pullT * pullOverEdge(cube, level, face, {column, row}, true);
          made.setTexel(level, face, column, row, glm::max(value, glm::vec4(0.0f)));
        }
      }
    }
  }
  return made;
}

glm::vec4 fetchWithinFace(const CubeMap& cube, const glm::vec3& direction, float level) {
  if (cube.empty()) return glm::vec4(0.0f);
  const CubePoint point = cubePoint(direction);
  const float clamped = std::clamp(level, 0.0f, cube.maxLevel());
  const int lower = std::min(static_cast<int>(clamped), cube.levels() - 1);
  const float fraction = clamped - static_cast<float>(lower);
  const glm::vec4 value = levelWithinFace(cube, point, lower);
  if (!(fraction > 0.0f)) return value;
  return glm::mix(value, levelWithinFace(cube, point, lower + 1), fraction);
}

}  // namespace boxprobe
