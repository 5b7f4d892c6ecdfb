// A cube as a flat picture: right way round, and every direction and texel found again where it was drawn.
#include "filters/core/picture/cube_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "filters/math/cube/srgb.h"
#include "filters/math/shared/display_math.h"
#include "tests/support/shown_light.h"

namespace boxprobe {
namespace {

using test::lightShown;
using test::shownLight;

const glm::vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

glm::vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

/// Every texel a colour of its own.
CubeMap numberedCube(int faceSize) {
  CubeMap cube(faceSize, 1);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < faceSize; ++row) {
      for (int column = 0; column < faceSize; ++column) {
        cube.setTexel(0, face, column, row,
                      {static_cast<float>(face + 8) / 16, static_cast<float>(column + 8) / 16,
                       static_cast<float>(row + 8) / 16, 1});
      }
    }
  }
  return cube;
}

TEST(CubePicture, SomeoneInsideLookingAlongZSeesXToTheLeftAndYAbove) {
  for (const auto kind : {CubePictureKind::Cross, CubePictureKind::LatLong}) {
    const CubePicture picture(kind, 400);
    // The cross's middle tile is its second: the picture's middle lies an eighth further on.
    const glm::dvec2 ahead = picture.position({0, 0, 1});
    EXPECT_NEAR(ahead.x, kind == CubePictureKind::Cross ? 150.0 : 200.0, 1e-9);
    EXPECT_NEAR(ahead.y, picture.height() / 2.0, 1e-9);
    EXPECT_LT(picture.position({0.3f, 0, 1}).x, ahead.x);
    EXPECT_LT(picture.position({1, 0, 0}).x, ahead.x);
    EXPECT_LT(picture.position({0, 0.3f, 1}).y, ahead.y);
    EXPECT_LT(picture.position({0, 1, 0}).y, ahead.y);
    EXPECT_GT(picture.position({0, -1, 0}).y, ahead.y);
  }
}

TEST(CubePicture, TheCrossIsContinuousAcrossTheEdgesOfItsMiddleFace) {
  const CubePicture picture(CubePictureKind::Cross, 400);
  // Just either side of the edge: neighbours on the cube, neighbours in the picture.
  for (const glm::vec3& edge : {glm::vec3(1, 0.3f, 1), glm::vec3(-1, 0.3f, 1), glm::vec3(0.3f, 1, 1),
                                glm::vec3(0.3f, -1, 1), glm::vec3(-1, 0.3f, -1)}) {
    const glm::dvec2 a = picture.position(edge + 1e-4f * glm::vec3(0, 0, edge.z));
    const glm::dvec2 b = picture.position(edge - 1e-4f * glm::vec3(0, 0, edge.z));
    EXPECT_LT(glm::length(a - b), 0.1) << edge.x << " " << edge.y << " " << edge.z;
  }
}

TEST(CubePicture, DirectionsComeBack) {
  std::mt19937 random(7);
  for (const auto kind : {CubePictureKind::Cross, CubePictureKind::LatLong}) {
    const CubePicture picture(kind, 640);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
      const glm::vec3 direction = randomDirection(random);
      const auto back = picture.direction(picture.position(direction));
      ASSERT_TRUE(back);
      worst = std::max(worst, static_cast<double>(glm::length(glm::normalize(*back) - direction)));
    }
    EXPECT_LT(worst, 1e-6);
    EXPECT_FALSE(picture.direction({-1.0, 5.0}));
  }
  EXPECT_FALSE(CubePicture(CubePictureKind::Cross, 640).direction({10.0, 10.0})) << "the cross's corners are empty";
}

TEST(CubePicture, EveryTexelIsDrawnWhereItsOutlineSaysSo) {
  constexpr int kSize = 4;
  const CubeMap cube = numberedCube(kSize);
  for (const auto kind : {CubePictureKind::Cross, CubePictureKind::LatLong}) {
    const CubePicture picture(kind, 256);
    const ImageRgba8 image = drawCubePicture(cube, 0, picture, 1.0f);
    ASSERT_EQ(image.width, 256);
    ASSERT_EQ(image.height, picture.height());
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < kSize; ++row) {
        for (int column = 0; column < kSize; ++column) {
          const glm::vec3 middle = shading::cubeDirection(face, -0.75f + 0.5f * static_cast<float>(column),
                                                          -0.75f + 0.5f * static_cast<float>(row));
          const glm::dvec2 at = picture.position(middle);
          // The lat-long map interpolates: only the texel's very middle has its own colour.
          const std::size_t pixel = 4 * (static_cast<std::size_t>(at.y) * 256 + static_cast<std::size_t>(at.x));
          const glm::vec4 texel = cube.texel(0, face, column, row);
          for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(image.pixels[pixel + static_cast<std::size_t>(c)], std::lround(255.0 * shownLight(texel[c])),
                        kind == CubePictureKind::Cross ? 0 : 14)
                << face << " " << column << " " << row;
          }
          const auto outline = picture.texelOutline(kSize, face, column, row);
          double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
          for (const auto& point : outline) {
            left = std::min(left, point.x), right = std::max(right, point.x);
            top = std::min(top, point.y), bottom = std::max(bottom, point.y);
          }
          const double x = at.x < left ? at.x + 256.0 : at.x > right ? at.x - 256.0 : at.x;
          EXPECT_TRUE(x > left && x < right && at.y > top && at.y < bottom) << face << " " << column << " " << row;
        }
      }
    }
  }
}

TEST(DisplayBytes, AreThoseThatTheLightWasDecodedFrom) {
  for (int byte = 0; byte < 256; ++byte) {
    EXPECT_EQ(displayByte(lightShown(byte / 255.0)), byte);
    EXPECT_EQ(displayByte(static_cast<double>(linearOfSrgb(static_cast<std::uint8_t>(byte)))), byte);
  }
  EXPECT_EQ(displayByte(-0.3), 0);
  EXPECT_EQ(displayByte(1.0e30), 255);
  EXPECT_EQ(displayByte(std::numeric_limits<double>::infinity()), 255);
  EXPECT_EQ(displayByte(std::numeric_limits<double>::quiet_NaN()), 0);
  const std::array<std::uint8_t, 3> shown = displayBytes({0.02f, 0.11f, 0.7f}, 0.5);
  EXPECT_EQ(shown[0], std::lround(255.0 * shownLight(0.01)));
  EXPECT_EQ(shown[1], std::lround(255.0 * shownLight(0.055)));
  EXPECT_EQ(shown[2], std::lround(255.0 * shownLight(0.35)));
}

TEST(CubePicture, OutlinesOnTheLatLongMapNeverJumpAcrossIt) {
  const CubePicture picture(CubePictureKind::LatLong, 360);
  for (const int size : {1, 2, 8}) {
    for (int face = 0; face < 6; ++face) {
      for (int i = 0; i < size * size; ++i) {
        const auto outline = picture.texelOutline(size, face, i % size, i / size);
        for (std::size_t k = 1; k < outline.size(); ++k) EXPECT_LE(std::abs(outline[k].x - outline[k - 1].x), 180.0);
      }
    }
  }
}

TEST(CubePicture, MakingItSmallerKeepsTheLight) {
  CubeMap cube(64, 1);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  double mean = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < 64 * 64; ++i) {
      const float value = uniform(random);
      mean += value / (6.0 * 64 * 64);
      cube.setTexel(0, face, i % 64, i / 64, glm::vec4(value));
    }
  }
  const ImageRgba8 image = drawCubePicture(cube, 0, CubePicture(CubePictureKind::Cross, 32), 1.0f);
  double shown = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    if (image.pixels[i + 3] == 0) continue;
    shown += lightShown(image.pixels[i] / 255.0);
    ++count;
  }
  EXPECT_EQ(count, 6 * 8 * 8);
  EXPECT_NEAR(shown / count, mean, 2e-3);
}

TEST(CubePicture, TheLatLongMapHoldsWhatLookupsGive) {
  const CubeMap cube = numberedCube(8);
  const CubePicture picture(CubePictureKind::LatLong, 128);
  const ImageRgba8 image = drawCubePicture(cube, 0, picture, 1.0f);
  ASSERT_EQ(image.pixels.size(), 128u * 64 * 4);
  for (int i = 0; i < 128 * 64; i += 37) {
    const glm::vec4 expected = cube.fetch(*picture.direction({i % 128 + 0.5, i / 128 + 0.5}), 0.0f);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(image.pixels[4 * static_cast<std::size_t>(i) + static_cast<std::size_t>(c)],
                std::lround(255.0 * shownLight(expected[c])));
    }
  }
}

}  // namespace
}  // namespace boxprobe
