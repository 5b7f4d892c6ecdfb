// The measures of the benchmark on pictures whose error is known beforehand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "filters/core/base/errors.h"
#include "filters/reference/measure/flip.h"
#include "filters/reference/measure/metrics.h"

namespace boxprobe {
namespace {

ImageRgbaF flat(int width, int height, glm::vec3 color) {
  ImageRgbaF image{width, height, std::vector<float>(static_cast<std::size_t>(width * height) * 4, 1.0f)};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (i % 4 < 3) image.pixels[i] = color[static_cast<int>(i % 4)];
  }
  return image;
}

double mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

TEST(ReferenceMetrics, EqualPicturesHaveNoError) {
  const ImageRgbaF image = flat(20, 10, {0.2f, 3.0f, 50.0f});
  const PictureError error = pictureError(image, image);
  EXPECT_EQ(error.toneMappedRmse, 0.0);
  EXPECT_EQ(error.relativeRmse, 0.0);
  EXPECT_EQ(error.brightnessRatio, 1.0);
  EXPECT_EQ(error.flip, 0.0);
  EXPECT_EQ(error.pixels, 200u);
}

TEST(ReferenceMetrics, ByHand) {
  const PictureError error = pictureError(flat(4, 4, glm::vec3(3.0f)), flat(4, 4, glm::vec3(1.0f)));
  EXPECT_NEAR(error.toneMappedRmse, std::pow(0.75, 1 / 2.2) - std::pow(0.5, 1 / 2.2), 1e-12);
  EXPECT_NEAR(error.relativeRmse, 2.0, 1e-12);
  EXPECT_NEAR(error.brightnessRatio, 3.0, 1e-12);
}

TEST(ReferenceMetrics, OnlyTheMaskCounts) {
  ImageRgbaF picture = flat(2, 1, glm::vec3(1.0f)), reference = picture;
  picture.pixels[4] = 100.0f;
  EXPECT_EQ(pictureError(picture, reference, {true, false}).relativeRmse, 0.0);
  EXPECT_GT(pictureError(picture, reference, {false, true}).relativeRmse, 10.0);
  EXPECT_EQ(pictureError(picture, reference, {true, false}).pixels, 1u);
}

TEST(ReferenceMetrics, ExtremesStayNumbers) {
  const PictureError black = pictureError(flat(3, 3, glm::vec3(0.0f)), flat(3, 3, glm::vec3(0.0f)));
  EXPECT_EQ(black.relativeRmse, 0.0);
  EXPECT_EQ(black.brightnessRatio, 1.0);
  const ImageRgbaF infinite = flat(3, 3, glm::vec3(std::numeric_limits<float>::infinity()));
  EXPECT_EQ(pictureError(infinite, infinite).toneMappedRmse, 0.0);
  EXPECT_EQ(toneMapped(-1.0), 0.0);
}

TEST(ReferenceMetrics, RefusesWhatCannotBeCompared) {
  EXPECT_THROW(pictureError(flat(3, 3, {}), flat(3, 4, {})), InputError);
  EXPECT_THROW(pictureError(flat(1, 1, {}), flat(1, 1, {}), {false}), InputError);
}

TEST(Flip, BlackOnWhiteIsTheWholeScale) {
  // Tone mapping never reaches 1: as white as a float gets.
  const auto map = flipMap(flat(64, 64, glm::vec3(0.0f)), flat(64, 64, glm::vec3(1e9f)));
  // The paper's own figure for black against white is about 0.97: the very largest difference is green against blue.
  EXPECT_NEAR(mean(map), 0.97, 0.01);
}

TEST(Flip, BlueOnGreenIsItsDefinitionOfOne) {
  const auto map = flipMap(flat(64, 64, {0.0f, 1e9f, 0.0f}), flat(64, 64, {0.0f, 0.0f, 1e9f}));
  EXPECT_NEAR(mean(map), 1.0, 1e-3);
}

TEST(Flip, FineNoiseCountsForLessThanTheSameDifferenceInOnePlace) {
  // A check of single pixels is blurred away by the eye; an even shift of the same size is not.
  const ImageRgbaF gray = flat(64, 64, glm::vec3(0.3f));
  ImageRgbaF check = gray, shifted = flat(64, 64, glm::vec3(0.33f));
  for (int i = 0; i < 64 * 64; ++i) {
    const float sign = (i % 64 + i / 64) % 2 == 0 ? 1.0f : -1.0f;
    for (int c = 0; c < 3; ++c) check.pixels[static_cast<std::size_t>(4 * i + c)] += 0.03f * sign;
  }
  // Color alone: feature differences of a regular check are small as well.
  EXPECT_LT(mean(flipMap(check, gray)), 0.5 * mean(flipMap(shifted, gray)));
}

TEST(Flip, GrowsWithTheDifferenceAndIsSymmetric) {
  const ImageRgbaF gray = flat(32, 32, glm::vec3(0.3f));
  double previous = 0.0;
  for (const float value : {0.31f, 0.35f, 0.5f, 1.0f, 5.0f}) {
    const ImageRgbaF other = flat(32, 32, glm::vec3(value));
    const double there = mean(flipMap(other, gray)), back = mean(flipMap(gray, other));
    EXPECT_GT(there, previous);
    EXPECT_NEAR(there, back, 1e-6);
    previous = there;
  }
}

TEST(Flip, AnEdgeThatIsMissingIsSeen) {
  ImageRgbaF line = flat(64, 64, glm::vec3(0.3f));
  for (int y = 0; y < 64; ++y) {
    for (int c = 0; c < 3; ++c) line.pixels[static_cast<std::size_t>(4 * (64 * y + 32) + c)] = 1.0f;
  }
  const auto map = flipMap(flat(64, 64, glm::vec3(0.3f)), line);
  EXPECT_GT(map[64 * 32 + 32], 0.3f);
  EXPECT_NEAR(map[64 * 32 + 2], 0.0f, 0.02f);
}

}  // namespace
}  // namespace boxprobe
