// A sphere about the origin for tests that draw, with texture coordinates: u around, v down.
#pragma once

#include <cmath>

#include "filters/core/scene/model.h"

namespace boxprobe::test {

inline Mesh sphereMesh(float radius, int rows, int columns) {
  Mesh mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double a = 3.14159265358979 * row / rows, b = 2.0 * 3.14159265358979 * column / columns;
      const glm::vec3 n(std::sin(a) * std::cos(b), std::cos(a), -std::sin(a) * std::sin(b));
      mesh.positions.push_back(radius * n);
      mesh.normals.push_back(n);
      mesh.uv.emplace_back(static_cast<float>(column) / static_cast<float>(columns),
                           static_cast<float>(row) / static_cast<float>(rows));
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto i = static_cast<std::uint32_t>(row * (columns + 1) + column);
      const std::uint32_t j = i + static_cast<std::uint32_t>(columns) + 1;
      for (const std::uint32_t index : {i, j, i + 1, i + 1, j, j + 1}) mesh.indices.push_back(index);
    }
  }
  return mesh;
}

}  // namespace boxprobe::test
