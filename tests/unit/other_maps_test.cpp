// What lessons compare the program's cubemaps with: levels of plain means, faces that are looked up for themselves, and
// the edge fix-up.
#include "app/lessons/other_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace boxprobe {
namespace {

/// Every texel of every level at random.
CubeMap randomCube(int faceSize, int levels) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> light(0.0f, 1.0f);
  CubeMap cube(faceSize, levels);
  for (int level = 0; level < levels; ++level) {
    const int size = cube.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (int i = 0; i < size * size; ++i) {
        cube.setTexel(level, face, i % size, i / size, {light(random), light(random), light(random), 1.0f});
      }
    }
  }
  return cube;
}

float texelMiddle(int index, int size) {
  return (2.0f * static_cast<float>(index) + 1.0f) / static_cast<float>(size) - 1.0f;
}

TEST(OtherMaps, PlainMeansKeepTheCaptureAndAverageFour) {
  const CubeMap cube = randomCube(16, 4), means = withPlainMeans(cube);
  ASSERT_EQ(means.levels(), 4);
  EXPECT_EQ(means.texel(0, 3, 5, 9), cube.texel(0, 3, 5, 9));
  EXPECT_NE(means.texel(2, 3, 1, 2), cube.texel(2, 3, 1, 2));
  glm::vec4 four(0.0f), sixteen(0.0f);
  for (int i = 0; i < 4; ++i) four += cube.texel(0, 1, 6 + i % 2, 10 + i / 2);
  for (int i = 0; i < 16; ++i) sixteen += cube.texel(0, 5, 4 + i % 4, 8 + i / 4);
  EXPECT_LT(glm::length(means.texel(1, 1, 3, 5) - four / 4.0f), 1e-6f);
  EXPECT_LT(glm::length(means.texel(2, 5, 1, 2) - sixteen / 16.0f), 1e-6f);
}

TEST(OtherMaps, WithinAFaceBothLookupsAreTheSame) {
  const CubeMap cube = randomCube(16, 3);
  std::mt19937 random(11);
  std::uniform_real_distribution<float> inner(-0.7f, 0.7f), level(0.0f, 2.0f);
  for (int i = 0; i < 2000; ++i) {  // of level 2 the outermost texel middles are at .75
    const glm::vec3 direction = shading::cubeDirection(i % 6, inner(random), inner(random));
    const float at = level(random);
    EXPECT_LT(glm::length(fetchWithinFace(cube, direction, at) - cube.fetch(direction, at)), 1e-5f);
  }
}

TEST(OtherMaps, AtAnEdgeOneLookupJumpsAndTheOtherDoesNot) {
  const CubeMap cube = randomCube(16, 3);
  float alone = 0.0f, seamless = 0.0f;
  for (int i = 0; i < 200; ++i) {
    const float t = -0.9f + 0.009f * static_cast<float>(i);
    const glm::vec3 edge = shading::cubeDirection(0, 1.0f, t);
    const glm::vec3 here = edge + 1e-5f * glm::vec3(1, 0, 0), beyond = edge - 1e-5f * glm::vec3(1, 0, 0);
    ASSERT_NE(cubePoint(here).face, cubePoint(beyond).face);
    alone = std::max(alone, glm::length(fetchWithinFace(cube, here, 2) - fetchWithinFace(cube, beyond, 2)));
    seamless = std::max(seamless, glm::length(cube.fetch(here, 2) - cube.fetch(beyond, 2)));
  }
  EXPECT_GT(alone, 0.2f);
  EXPECT_LT(seamless, 0.001f);
}

TEST(OtherMaps, TheFixupMakesTexelsAtAnEdgeEqualAndLeavesTheMiddle) {
  const CubeMap cube = randomCube(32, 3), fixed = withEdgeFixup(cube, 4);
  EXPECT_EQ(fixed.texel(0, 0, 0, 7), cube.texel(0, 0, 0, 7)) << "level 0 is the capture";
  EXPECT_EQ(fixed.texel(1, 2, 6, 9), cube.texel(1, 2, 6, 9)) << "further than four texels from every edge";
  for (int level = 1; level < 3; ++level) {
    const int size = fixed.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (int along = 0; along < size; ++along) {
        const glm::vec3 across =
            shading::directionAcrossEdge(face, 1.0f, texelMiddle(along, size), false, static_cast<float>(size));
        const CubePoint there = cubePoint(across);
        const auto index = [size](float x) {
          return std::clamp(static_cast<int>(0.5f * (x + 1.0f) * static_cast<float>(size)), 0, size - 1);
        };
        const glm::vec4 other = fixed.texel(level, there.face, index(there.s), index(there.t));
        EXPECT_LT(glm::length(fixed.texel(level, face, size - 1, along) - other), 1e-5f)
            << "level " << level << ", face " << face << ", texel " << along;
      }
    }
  }
}

}  // namespace
}  // namespace boxprobe
