#include "filters/math/cube/flat_cube.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

namespace {

constexpr int kFaces = 6;

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

std::vector<glm::vec4> paddedFace(const CubeMap& cube, int level, int face) {
  const int size = cube.levelSize(level), padded = size + 2;
  std::vector<glm::vec4> texels(static_cast<std::size_t>(padded) * static_cast<std::size_t>(padded));
  const auto at = [&](int column, int row) -> glm::vec4& {
    return texels[static_cast<std::size_t>((row + 1) * padded + column + 1)];
  };
  for (int i = 0; i < size; ++i) {
    const float* own = cube.face(level, face) + 4 * static_cast<std::size_t>(i) * static_cast<std::size_t>(size);
    std::copy_n(own, 4 * static_cast<std::size_t>(size), &at(0, i).x);
    at(-1, i) = beyondEdge(cube, level, face, -1, i);
    at(size, i) = beyondEdge(cube, level, face, size, i);
    at(i, -1) = beyondEdge(cube, level, face, i, -1);
    at(i, size) = beyondEdge(cube, level, face, i, size);
  }
  for (const int column : {-1, size}) {
    for (const int row : {-1, size}) {  // three texels meet there and share the weight of the missing fourth
      const int inColumn = std::clamp(column, 0, size - 1), inRow = std::clamp(row, 0, size - 1);
      at(column, row) = (at(inColumn, inRow) + at(column, inRow) + at(inColumn, row)) / 3.0f;
    }
  }
  return texels;
}

FlatCube flattenCube(const CubeMap& cube) {
  FlatCube flat;
  flat.width = kFaces * (cube.faceSize() + 2);
  for (int level = 0; level < cube.levels(); ++level) flat.height += cube.levelSize(level) + 2;
  flat.rgba.resize(4 * static_cast<std::size_t>(flat.width) * static_cast<std::size_t>(flat.height));
  std::size_t firstRow = 0;
  for (int level = 0; level < cube.levels(); ++level) {
    const auto padded = static_cast<std::size_t>(cube.levelSize(level) + 2);
    for (int face = 0; face < kFaces; ++face) {
      const std::vector<glm::vec4> texels = paddedFace(cube, level, face);
      for (std::size_t row = 0; row < padded; ++row) {
        const std::size_t to = (firstRow + row) * static_cast<std::size_t>(flat.width);
        std::copy_n(&texels[row * padded].x, 4 * padded,
                    &flat.rgba[4 * (to + static_cast<std::size_t>(face) * padded)]);
      }
    }
    firstRow += padded;
  }
  return flat;
}

}  // namespace boxprobe
