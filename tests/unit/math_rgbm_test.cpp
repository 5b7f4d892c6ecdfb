// RGBM against half float over a sweep of magnitudes: the error that eight bits must cost, and no more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "tests/support/rgbm_encoder.h"

namespace boxprobe {
namespace {

/// Texels whose largest component runs evenly over the logarithm from `least` to `most`, the others below it.
CubeMap sweep(float least, float most) {
  CubeMap cube(32, 1);
  constexpr int kCount = 6 * 32 * 32;
  for (int i = 0; i < kCount; ++i) {
    const float value = least * std::pow(most / least, static_cast<float>(i) / (kCount - 1));
    const auto below = [&](int n) { return value * static_cast<float>((i * n) % 97) / 96.0f; };
    float* texel = cube.face(0, 0) + 4 * i;
    texel[i % 3] = value;
    texel[(i + 1) % 3] = below(31);
    texel[(i + 2) % 3] = below(57);
  }
  return cube;
}

TEST(Rgbm, DecodingIsTheInstruction) {
  EXPECT_EQ(decodeRgbm({255, 51, 0, 255}, {5.0f, 1.0f}), glm::vec3(5.0f, 1.0f, 0.0f));
  EXPECT_FLOAT_EQ(decodeRgbm({255, 0, 0, 51}, {2.0f, 2.0f}).x, 2.0f * 0.04f);
}

TEST(Rgbm, ColoursOfEnginesAreSrgbAndMIsNot) {
  // Unity's instruction for linear colour is its gamma-space one, 5 * M * colour, to the 2.2, but for the curve of
  // sRGB, which is near that power.
  const RgbmInstruction engine{34.493242f, 2.2f, true};
  EXPECT_EQ(decodeRgbm({255, 0, 0, 255}, engine), glm::vec3(34.493242f, 0.0f, 0.0f));
  EXPECT_NEAR(decodeRgbm({0, 188, 0, 255}, engine).y, 34.493242 * 0.5028865, 1e-4) << "byte 188 is 0.5028865";
  EXPECT_NEAR(decodeRgbm({0, 200, 0, 128}, engine).y / std::pow(5.0 * 200 / 255.0 * 128 / 255.0, 2.2), 1.0, 0.02);
  const RgbmInstruction doubleLdr{4.594793f, 1.0f, true};
  EXPECT_NEAR(decodeRgbm({255, 128, 0, 255}, doubleLdr).y, 4.594793 * 0.2158605, 1e-5);
}

TEST(Rgbm, ErrorStaysAtTheStepOfEightBits) {
  // Half a step of a component that is at least 254 steps high is 0.2 %; multipliers near the dark end are too coarse
  // to keep the largest component up there, which is where the sweep must not start.
  const RgbmError linear = measureRgbm(sweep(0.5f, 5.0f), {5.0f, 1.0f});
  EXPECT_EQ(linear.texels, 6144u);
  EXPECT_EQ(linear.clipped, 0u);
  EXPECT_EQ(linear.vanished, 0u);
  EXPECT_LT(linear.worstRelative, 0.0021);
  EXPECT_LT(linear.rmsRelative, 0.0013);
  EXPECT_GT(linear.rmsRelative, linear.halfWorstRelative) << "eight bits cannot be better than half";
  EXPECT_LE(linear.halfWorstRelative, 0.0005);
  EXPECT_GT(linear.halfWorstRelative, 0.0);

  const RgbmError bent = measureRgbm(sweep(0.01f, 34.0f), {34.493242f, 2.2f});
  EXPECT_EQ(bent.clipped, 0u);
  EXPECT_LT(bent.worstRelative, 0.0045);
  EXPECT_LE(bent.meanRelative, bent.rmsRelative);
  EXPECT_LE(bent.percentile99Relative, bent.worstRelative);

  // Steps of sRGB are coarser at the bright end, where the largest component is kept, and finer below it.
  const RgbmError engine = measureRgbm(sweep(0.01f, 34.0f), {34.493242f, 2.2f, true});
  EXPECT_EQ(engine.clipped, 0u);
  EXPECT_EQ(engine.vanished, 0u);
  EXPECT_LT(engine.worstRelative, 0.0045);
}

TEST(Rgbm, ABestMultiplierIsNoWorseThanTheSmallest) {
  const RgbmInstruction instruction{5.0f, 1.0f};
  for (int i = 1; i < 2000; ++i) {
    const glm::vec3 color(0.0025f * static_cast<float>(i), 0.0017f * static_cast<float>((i * 7) % 1000), 0.01f);
    const float brightest = std::max({color.x, color.y, color.z});
    const auto multiplier = static_cast<std::uint8_t>(std::ceil(brightest / 5.0f * 255.0f));
    RgbmTexel plain{0, 0, 0, multiplier};
    for (int c = 0; c < 3; ++c) {
      const float scale = 5.0f * static_cast<float>(multiplier) / 255.0f;
      plain[static_cast<std::size_t>(c)] =
          static_cast<std::uint8_t>(std::lround(std::min(color[c] / scale, 1.0f) * 255.0f));
    }
    const auto worst = [&](const RgbmTexel& texel) {
      const glm::vec3 d = glm::abs(decodeRgbm(texel, instruction) - color);
      return std::max({d.x, d.y, d.z});
    };
    EXPECT_LE(worst(encodeRgbm(color, instruction)), worst(plain) * 1.0001f) << i;
  }
}

TEST(Rgbm, WhatDoesNotFitIsClippedKeepsItsHueAndIsCounted) {
  const RgbmInstruction instruction{5.0f, 1.0f};
  const glm::vec3 clipped = decodeRgbm(encodeRgbm({50.0f, 25.0f, 0.0f}, instruction), instruction);
  EXPECT_FLOAT_EQ(clipped.x, 5.0f);
  EXPECT_NEAR(clipped.y, 2.5f, 0.01f);
  CubeMap cube(2, 1);
  for (int i = 0; i < 24; ++i) cube.face(0, 0)[4 * i] = 1.0f;
  cube.face(0, 0)[0] = 10.0f;
  cube.face(0, 0)[4] = -1.0f;
  const RgbmError error = measureRgbm(cube, instruction);
  EXPECT_EQ(error.texels, 24u);
  EXPECT_EQ(error.clipped, 2u);
  EXPECT_NEAR(error.lostEnergy, (5.0 - 1.0) / 31.0, 1e-3);
}

TEST(Rgbm, DarkTexelsVanishWhereMIsLinearAndNotWhereItIsBent) {
  CubeMap cube(2, 1);
  for (int i = 0; i < 24; ++i) cube.face(0, 0)[4 * i] = 1e-5f;
  EXPECT_EQ(measureRgbm(cube, {5.0f, 1.0f}).vanished, 24u);
  EXPECT_EQ(measureRgbm(cube, {34.493242f, 2.2f}).vanished, 0u);
}

TEST(Rgbm, IsTotal) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const RgbmInstruction instruction{5.0f, 1.0f};
  EXPECT_EQ(decodeRgbm(encodeRgbm({inf, 0, 0}, instruction), instruction), glm::vec3(5.0f));
  EXPECT_EQ(decodeRgbm(encodeRgbm({nan, -1, 0}, instruction), instruction), glm::vec3(0.0f));
  EXPECT_EQ(encodeRgbm({1, 1, 1}, {0.0f, 1.0f}), (RgbmTexel{0, 0, 0, 0}));
  EXPECT_EQ(decodeRgbm(encodeRgbm({1, 1, 1}, {1.0f, 0.0f}), {1.0f, 0.0f}), glm::vec3(1.0f));
}

}  // namespace
}  // namespace boxprobe
