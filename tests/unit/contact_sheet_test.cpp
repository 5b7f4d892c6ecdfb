// A benchmark's contact sheet, pixel by pixel: five cells a row, small pictures enlarged by a whole number, errors
// below them in colours.
#include "app/cli/report/contact_sheet.h"

#include <gtest/gtest.h>

#include <array>

#include "filters/math/shared/display_math.h"

namespace boxprobe {
namespace {

using Rgb = std::array<int, 3>;

constexpr int kAcross = 140, kDown = 40, kZoom = 3;  // 300 pixels at least
constexpr int kWide = kAcross * kZoom, kHigh = kDown * kZoom, kCell = kWide + 10, kTall = 24 + 2 * kHigh + 2 + 10;

float lightAt(int picture, int x, int y, int c) {
  return 0.01f * static_cast<float>((17 * picture + 3 * x + 29 * y + 41 * c) % 97);
}

ImageRgbaF pictureOf(int number) {
  ImageRgbaF image{kAcross, kDown, {}};
  for (int y = 0; y < kDown; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      for (int c = 0; c < 4; ++c) image.pixels.push_back(c == 3 ? 1.0f : lightAt(number, x, y, c));
    }
  }
  return image;
}

class Sheet {
 public:
  Sheet() {
    std::vector<ContactPicture> pictures;
    for (int i = 1; i <= 6; ++i) {
      ContactPicture picture{"technique " + std::to_string(i), pictureOf(i), {}};
      for (int y = 0; y < kDown; ++y) {
        for (int x = 0; x < kAcross; ++x) picture.error.push_back(errorAt(i, x, y));
      }
      pictures.push_back(picture);
    }
    image = contactSheet("a title", pictureOf(0), pictures, 1.7, 0.2);
  }
  /// Places of the scale whose colours are given, of 0.2 each, and what is not measured.
  static float errorAt(int number, int x, int y) {
    const float at[] = {0.0f, 0.06f, 0.12f, 0.17f, 0.2f, 0.9f, -1.0f};
    return at[(x + 2 * y + number) % 7];
  }
  static Rgb errorColor(int number, int x, int y) {
    const Rgb at[] = {{8, 5, 26},      {92, 23, 110},   {217, 71, 84},  {252, 171, 69},
                      {252, 250, 191}, {252, 250, 191}, {205, 205, 208}};
    return at[(x + 2 * y + number) % 7];
  }
  Rgb at(int x, int y) const {
    const std::size_t i =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
  }
  static bool near(const Rgb& a, const Rgb& b) {
    return std::abs(a[0] - b[0]) <= 1 && std::abs(a[1] - b[1]) <= 1 && std::abs(a[2] - b[2]) <= 1;
  }
  struct Ink {
    int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1, pixels = 0;
  };
  /// Of what is dark within a rectangle.
  Ink ink(int left, int top, int right, int bottom) const {
    Ink found;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const Rgb color = at(x, y);
        if (color[0] > 128 || color[1] > 128 || color[2] > 128) continue;
        found.left = std::min(found.left, x);
        found.right = std::max(found.right, x);
        found.top = std::min(found.top, y);
        found.bottom = std::max(found.bottom, y);
        ++found.pixels;
      }
    }
    return found;
  }

  ImageRgba8 image;
};

TEST(ContactSheet, ShowsEachPictureAndItsErrors) {
  const Sheet sheet;
  ASSERT_EQ(sheet.image.width, 5 * kCell + 10);
  ASSERT_EQ(sheet.image.height, 40 + 2 * kTall + 10);
  ASSERT_EQ(sheet.image.pixels.size(), 4u * static_cast<std::size_t>(sheet.image.width * sheet.image.height));
  for (int cell = 0; cell < 7; ++cell) {
    const int left = 10 + cell % 5 * kCell, top = 40 + cell / 5 * kTall + 24, under = top + kHigh + 2;
    int wrong = 0, wrongErrors = 0;
    for (int y = 0; y < kHigh; ++y) {
      for (int x = 0; x < kWide; ++x) {
        const auto bytes = displayBytes({lightAt(cell, x / kZoom, y / kZoom, 0), lightAt(cell, x / kZoom, y / kZoom, 1),
                                         lightAt(cell, x / kZoom, y / kZoom, 2)},
                                        1.7);
        wrong += Sheet::near(sheet.at(left + x, top + y), {bytes[0], bytes[1], bytes[2]}) ? 0 : 1;
        if (cell == 0) continue;
        wrongErrors +=
            Sheet::near(sheet.at(left + x, under + y), Sheet::errorColor(cell, x / kZoom, y / kZoom)) ? 0 : 1;
      }
    }
    EXPECT_EQ(wrong, 0) << cell;
    EXPECT_EQ(wrongErrors, 0) << cell;
    // White between them.
    for (const int x : {left - 1, left + kWide}) {
      for (int y = top; y < under + kHigh && cell > 0; ++y) {
        EXPECT_EQ(sheet.at(x, y), (Rgb{255, 255, 255})) << cell << ": " << x << ", " << y;
      }
    }
    EXPECT_EQ(sheet.at(left + 5, top + kHigh), (Rgb{255, 255, 255}));
    EXPECT_EQ(sheet.at(left + 5, top + kHigh + 1), (Rgb{255, 255, 255}));
    // Its label stands above it.
    const Sheet::Ink label = sheet.ink(left, top - 24, left + kWide, top);
    EXPECT_GT(label.pixels, 30) << cell;
    EXPECT_NEAR(label.left, left + 1, 3);
    EXPECT_NEAR(label.bottom, top - 6, 5) << "letters reach below their line";
    EXPECT_LT(label.right, left + kWide / 2 + 40);
  }
  EXPECT_EQ(sheet.at(10 + 2 * kCell + 3, 40 + kTall + 24 + 3), (Rgb{255, 255, 255})) << "an empty cell";
  const Sheet::Ink title = sheet.ink(0, 0, sheet.image.width, 40);
  EXPECT_NEAR(title.left, 11, 3);
  EXPECT_NEAR(title.bottom, 28, 5);
}

TEST(ContactSheet, HasTheScaleOfItsErrors) {
  const Sheet sheet;
  const int left = 10, under = 40 + 24 + kHigh + 2, bar = 260;
  const auto fraction = [](double at) { return static_cast<int>(std::lround(at * (bar - 1))); };
  for (int y : {30, 37, 45}) {
    EXPECT_TRUE(Sheet::near(sheet.at(left, under + y), {8, 5, 26})) << y;
    EXPECT_TRUE(Sheet::near(sheet.at(left + bar - 1, under + y), {252, 250, 191})) << y;
    const Rgb middle = sheet.at(left + fraction(0.6), under + y);
    EXPECT_NEAR(middle[0], 217, 3);
    EXPECT_NEAR(middle[1], 71, 3);
    EXPECT_NEAR(middle[2], 84, 3);
  }
  EXPECT_EQ(sheet.at(left + bar, under + 37), (Rgb{255, 255, 255}));
  for (const int y : {29, 46}) EXPECT_EQ(sheet.at(left + bar / 2, under + y), (Rgb{255, 255, 255})) << y;
  // "0" at its beginning, the range at its end, and what the colours are above it.
  const Sheet::Ink zero = sheet.ink(left, under + 48, left + 30, under + 70);
  EXPECT_NEAR(zero.left, left + 1, 3);
  EXPECT_LT(zero.right, left + 14);
  EXPECT_NEAR(zero.bottom, under + 66, 5);
  const Sheet::Ink range = sheet.ink(left + 40, under + 48, left + kWide, under + 70);
  EXPECT_NEAR(range.left, left + bar - 70 + 1, 4);
  const Sheet::Ink words = sheet.ink(left, under + 4, left + kWide, under + 29);
  EXPECT_GT(words.right, left + 200);
  EXPECT_NEAR(words.bottom, under + 22, 5);
}

TEST(ContactSheet, EnlargesNothingThatIsLargeEnough) {
  const auto widthOf = [](int across, std::size_t pictures) {
    ImageRgbaF truth{across, 1, std::vector<float>(4 * static_cast<std::size_t>(across), 0.5f)};
    std::vector<ContactPicture> others(pictures,
                                       {"", truth, std::vector<float>(static_cast<std::size_t>(across), 0.0f)});
    const ImageRgba8 sheet = contactSheet("", truth, others, 1.0, 0.1);
    return std::pair(sheet.width, sheet.height);
  };
  EXPECT_EQ(widthOf(300, 4), std::pair(5 * 310 + 10, 40 + (24 + 2 + 2 + 10) + 10));
  EXPECT_EQ(widthOf(299, 5), std::pair(5 * 608 + 10, 40 + 2 * (24 + 4 + 2 + 10) + 10));
  EXPECT_EQ(widthOf(150, 1).first, 5 * 310 + 10);
}

}  // namespace
}  // namespace boxprobe
