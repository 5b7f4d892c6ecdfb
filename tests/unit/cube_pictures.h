// Surroundings with values that tell where one looks, for the tests of files of cubes.
#pragma once

#include <Imath/half.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/io/cube/cube_file.h"

namespace boxprobe {

/// Smooth and different in every direction, from 0.1 to 3.1.
inline glm::vec3 smoothRadiance(const glm::vec3& direction) {
  const glm::vec3 d = glm::normalize(direction);
  return {1.6f + 1.5f * d.x, 1.6f + 1.5f * d.y, 1.6f + 1.5f * d.z * d.z * d.z};
}

/// One colour a face: +X red, -X cyan, +Y green, -Y magenta, +Z blue, -Z yellow, as the scene six-faces has them.
inline glm::vec3 faceColor(int face) {
  const glm::vec3 colors[6] = {{4, 0.5f, 0.5f}, {0.5f, 4, 4},    {0.5f, 4, 0.5f},
                               {4, 0.5f, 4},    {0.5f, 0.5f, 4}, {4, 4, 0.5f}};
  return colors[face];
}

template <typename Radiance>
CubeMap cubeOf(int faceSize, int levels, const Radiance& radiance) {
  CubeMap cube(faceSize, levels);
  for (int level = 0; level < levels; ++level) {
    const int size = cube.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          const auto at = [size](int i) {
            return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f;
          };
          const glm::vec3 direction = shading::cubeDirection(face, at(column), at(row));
          cube.setTexel(level, face, column, row, glm::vec4(radiance(direction), 1.0f));
        }
      }
    }
  }
  return cube;
}

inline CubeMap smoothCube(int faceSize, int levels = 1) {
  return cubeOf(faceSize, levels, smoothRadiance);
}
inline CubeMap colouredFaces(int faceSize) {
  return cubeOf(faceSize, 1, [](const glm::vec3& direction) { return faceColor(cubePoint(direction).face); });
}

/// Values as a GPU's half-float texture gives them back, noise in every texel, level by level.
inline CubeMap noisyHalfCube(int faceSize, int levels) {
  CubeMap cube(faceSize, levels);
  unsigned state = 1;
  for (int level = 0; level < levels; ++level) {
    const int size = cube.levelSize(level);
    float* values = cube.face(level, 0);
    for (int i = 0; i < 6 * size * size * 4; ++i) {
      state = state * 1664525u + 1013904223u;
      values[i] = half(std::exp(static_cast<float>(state >> 8) / 16777216.0f * 12.0f - 6.0f));
    }
  }
  return cube;
}

inline bool sameTexels(const CubeMap& a, const CubeMap& b) {
  if (a.faceSize() != b.faceSize() || a.levels() != b.levels()) return false;
  for (int level = 0; level < a.levels(); ++level) {
    const int count = 6 * 4 * a.levelSize(level) * a.levelSize(level);
    for (int i = 0; i < count; ++i) {
      if (a.face(level, 0)[i] != b.face(level, 0)[i]) return false;
    }
  }
  return true;
}

/// Radiance integrated over the sphere, a channel.
inline glm::dvec4 energy(const CubeMap& cube) {
  const int size = cube.faceSize();
  glm::dvec4 sum(0.0);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const auto at = [size](int i) { return 2.0 * i / size - 1.0; };
        sum += glm::dvec4(cube.texel(0, face, column, row)) *
               cubeSolidAngle(at(column), at(row), at(column + 1), at(row + 1));
      }
    }
  }
  return sum;
}

}  // namespace boxprobe
