// Cubemaps for tests of the prefilter, and what is measured on their levels.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "filters/math/cube/cube_map.h"

namespace boxprobe::test {

inline glm::vec3 texelDirection(int size, int face, int column, int row) {
  const auto at = [size](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f; };
  return glm::normalize(shading::cubeDirection(face, at(column), at(row)));
}

inline double texelSolidAngle(int size, int column, int row) {
  const auto edge = [size](int i) { return 2.0 * i / size - 1.0; };
  return cubeSolidAngle(edge(column), edge(row), edge(column + 1), edge(row + 1));
}

inline void forEachTexel(int size, const std::function<void(int face, int column, int row)>& body) {
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) body(face, column, row);
    }
  }
}

inline CubeMap cubeOf(int faceSize, const std::function<glm::vec3(const glm::vec3& direction)>& radiance) {
  CubeMap cube(faceSize, 1);
  forEachTexel(faceSize, [&](int face, int column, int row) {
    cube.setTexel(0, face, column, row, glm::vec4(radiance(texelDirection(faceSize, face, column, row)), 1.0f));
  });
  return cube;
}

/// A sky from dark to bright, and a lamp in one texel that lies `columnShare`, `rowShare` across a face.
inline CubeMap skyWithLamp(int faceSize, float columnShare, float rowShare, float lamp = 5.0e4f) {
  CubeMap cube =
      cubeOf(faceSize, [](const glm::vec3& d) { return glm::vec3(1.0f + 0.5f * d.y, 1.0f, 1.0f - 0.3f * d.x); });
  const auto at = [faceSize](float share) {
    return std::min(static_cast<int>(share * static_cast<float>(faceSize)), faceSize - 1);
  };
  cube.setTexel(0, 4, at(columnShare), at(rowShare), {lamp, lamp, lamp, 1.0f});
  return cube;
}

/// Integral over all directions.
inline double energy(const CubeMap& cube, int level) {
  double sum = 0.0;
  const int size = cube.levelSize(level);
  forEachTexel(size, [&](int face, int column, int row) {
    sum += texelSolidAngle(size, column, row) * cube.texel(level, face, column, row).x;
  });
  return sum;
}

/// The texel beside (column, row) across the face's edge at its right or below it, within the face or on the next one.
inline glm::vec4 neighbour(const CubeMap& cube, int level, int face, int column, int row, bool below) {
  const int size = cube.levelSize(level);
  const int c = column + (below ? 0 : 1), r = row + (below ? 1 : 0);
  if (c < size && r < size) return cube.texel(level, face, c, r);
  const auto at = [size](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f; };
  const glm::vec3 across = shading::directionAcrossEdge(face, 1.0f, below ? at(column) : at(row), below, float(size));
  return cube.fetch(across, static_cast<float>(level));
}

}  // namespace boxprobe::test
