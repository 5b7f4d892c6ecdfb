// What whole pictures are off, part by part, on pictures whose errors follow by hand.
#include "filters/reference/bench/whole_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace boxprobe {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ImageRgbaF pixels(const std::vector<float>& grey) {
  ImageRgbaF image;
  image.width = static_cast<int>(grey.size());
  image.height = 1;
  for (const float g : grey) image.pixels.insert(image.pixels.end(), {g, 2.0f * g, 3.0f * g, 1.0f});
  return image;
}

/// A background, a rough wall near another, a glossy one behind a lamp, a lamp, glass.
std::vector<SeenPoint> seenRow() {
  std::vector<SeenPoint> seen(5);
  for (std::size_t i = 1; i < 5; ++i) seen[i].surface = true;
  seen[1].roughness = 0.7;
  seen[1].elevation = 14.0;
  seen[1].nearAnother = true;
  seen[2].roughness = 0.1;
  seen[2].elevation = 45.0;
  seen[2].glossy = seen[2].facesNoLamp = true;
  seen[3].lamp = true;
  seen[4].glass = true;
  seen[4].roughness = 0.4;
  seen[4].elevation = 20.0;
  return seen;
}

const PartError* find(const std::vector<PartError>& parts, const std::string& name) {
  for (const PartError& part : parts) {
    if (part.part == name) return &part;
  }
  return nullptr;
}

TEST(WholePicture, EveryPartIsOffByWhatItsPixelsAre) {
  const ReferencePicture truth{pixels({1.0f, 2.0f, 4.0f, 8.0f, 1.0f}), pixels({0.0f, 0.5f, 0.0f, 0.0f, 0.0f})};
  const auto parts = partErrors(pixels({1.0f, 3.0f, 3.0f, 8.0f, 1.0f}), truth, seenRow());
  const auto expectPart = [&](const char* name, std::size_t count, double light, double rmse) {
    const PartError* part = find(parts, name);
    ASSERT_NE(part, nullptr) << name;
    EXPECT_EQ(part->pixels, count) << name;
    EXPECT_NEAR(part->light, light, 1e-6) << name;
    EXPECT_NEAR(part->relativeRmse, rmse, 1e-6) << name;
  };
  // A difference of 1 with a standard error of 0.5, a difference of 1 without.
  expectPart("all", 5, 1.0, std::sqrt((1.0 - 0.25 + 1.0) / (1.0 + 4.0 + 16.0 + 64.0 + 1.0)));
  expectPart("diffuse", 1, 1.5, std::sqrt(0.75 / 4.0));
  expectPart("glossy", 1, 0.75, 0.25);
  expectPart("behind a lamp", 1, 0.75, 0.25);
  expectPart("within 5 cm of a wall", 1, 1.5, std::sqrt(0.75 / 4.0));
  expectPart("roughness 0.1 to 0.3", 1, 0.75, 0.25);
  expectPart("roughness 0.3 to 0.6", 1, 1.0, 0.0);
  expectPart("roughness 0.6 to 1", 1, 1.5, std::sqrt(0.75 / 4.0));
  expectPart("seen under 0 to 15 degrees", 1, 1.5, std::sqrt(0.75 / 4.0));
  expectPart("seen under 15 to 45 degrees", 1, 1.0, 0.0);
  expectPart("seen under 45 to 90 degrees", 1, 0.75, 0.25);
  EXPECT_EQ(find(parts, "roughness 0 to 0.1"), nullptr);
  EXPECT_NEAR(find(parts, "diffuse")->noise, std::sqrt(0.25 / 4.0), 1e-6);
}

TEST(WholePicture, APartWithoutPixelsIsADash) {
  const ReferencePicture truth{pixels({2.0f}), pixels({0.0f})};
  std::vector<SeenPoint> seen(1);
  seen[0].surface = true;
  seen[0].roughness = 0.8;
  const std::string table = wholeTable({{"hall", "low", "as it is", "all", partErrors(pixels({3.0f}), truth, seen)}});
  EXPECT_THAT(
      table,
      HasSubstr("hall         low       as it is               |    1.50   0.500 |    1.50   0.500 |         -"));
  EXPECT_THAT(table, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace boxprobe
