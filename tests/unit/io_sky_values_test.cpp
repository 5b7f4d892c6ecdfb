// What becomes of texels that are no radiance, and of suns: value by value, against io_sky_values.txt; and where each
// rule for a sun ends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>

#include "filters/io/cube/picture_repair.h"
#include "filters/io/cube/sky_sun.h"
#include "tests/support/kept_values.h"
#include "tests/unit/cube_pictures.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;

constexpr double kHalfTurn = 3.14159265358979323846;
constexpr float kInfinite = std::numeric_limits<float>::infinity(), kNoNumber = std::numeric_limits<float>::quiet_NaN();

using SkyLight = std::function<glm::dvec3(const glm::dvec3& direction)>;

glm::dvec3 directionOf(int x, int y, int width, int height) {
  const double longitude = kHalfTurn - 2 * kHalfTurn * (x + 0.5) / width,
               latitude = kHalfTurn / 2 - kHalfTurn * (y + 0.5) / height;
  return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
}

ImageRgbaF skyOf(int width, int height, const SkyLight& light) {
  ImageRgbaF image;
  image.width = width;
  image.height = height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec3 color(light(directionOf(x, y, width, height)));
      image.pixels.insert(image.pixels.end(), {color.x, color.y, color.z, 0.75f});
    }
  }
  return image;
}

void addImage(test::KeptValues& values, const std::string& label, const ImageRgbaF& image, int bands = 4) {
  const std::size_t texels = image.pixels.size() / 4 / std::size_t(bands);
  for (int band = 0; band < bands; ++band) {
    values.addTexels(label + " " + std::to_string(band), &image.pixels[4 * texels * std::size_t(band)], texels);
  }
}

void addRepairs(test::KeptValues& values, const PictureRepairs& repairs) {
  values.add("  found",
             {double(repairs.notFinite), double(repairs.negative), double(repairs.beyondHalf), repairs.lightLost});
  for (const std::string& text : repairs.sentences()) values.add("  " + text);
}

void addRepaired(test::KeptValues& values) {
  // No texel equals another; what is no number stands at corners, edges and side by side.
  const auto broken = [](int width, int height) {
    ImageRgbaF image;
    image.width = width;
    image.height = height;
    for (int i = 0; i < 4 * width * height; ++i) image.pixels.push_back(0.5f + 0.125f * float(i * 29 % 97));
    const auto set = [&](int x, int y, const glm::vec4& value) {
      for (int c = 0; c < 4; ++c) image.pixels[4 * std::size_t(y * width + x) + std::size_t(c)] = value[c];
    };
    set(0, 0, {kNoNumber, 2, 3, 1});
    set(width - 1, 1, {4, kNoNumber, kNoNumber, 0.5f});
    set(2, 2, {kNoNumber, kNoNumber, kNoNumber, 0.25f});
    set(3, 2, {kNoNumber, 0, 5, 0.25f});
    set(1, height - 1, {kInfinite, kNoNumber, 7, 1});
    set(4, 1, {kInfinite, 80000, -kInfinite, kNoNumber});
    set(5, height - 1, {1, 2, 3, kInfinite});
    set(width - 1, height - 1, {-5, kNoNumber, 2, 1});
    return image;
  };
  for (const bool wraps : {true, false}) {
    ImageRgbaF image = broken(7, 4);
    PictureRepairs repairs;
    repairs.notFinite = 1;
    repairNotFinite(image, wraps, repairs);
    for (int i = 0; i < 28; ++i) {
      values.add("texel " + std::to_string(i), {image.pixels.begin() + 4 * i, image.pixels.begin() + 4 * i + 4});
    }
    addRepairs(values, repairs);
  }
  // Alone, and with nobody around who knows.
  for (const glm::vec4& texel : {glm::vec4(kNoNumber, 2, 3, 1), glm::vec4(kNoNumber, kNoNumber, kNoNumber, kNoNumber),
                                 glm::vec4(kNoNumber, kInfinite, 1e20f, 1)}) {
    ImageRgbaF image;
    image.width = image.height = 1;
    image.pixels.assign(&texel.x, &texel.x + 4);
    PictureRepairs repairs;
    repairNotFinite(image, true, repairs);
    values.add("alone", {image.pixels.begin(), image.pixels.end()});
  }
  ImageRgbaF image;
  image.width = 8;
  image.height = 1;
  image.pixels = {-1,    2, 3, 1, 1, -2,    3,     -1, 1, 2, -3,    70000, 65504, 1,     1,     1,
                  65505, 1, 1, 1, 1, 70000, 70000, 1,  1, 2, 4e30f, 1,     2e30f, 4e30f, 1e30f, 1};
  PictureRepairs repairs;
  limitRadiance(image, repairs);
  for (int i = 0; i < 8; ++i) {
    values.add("limited", {image.pixels.begin() + 4 * i, image.pixels.begin() + 4 * i + 4});
  }
  addRepairs(values, repairs);
}

glm::dvec3 smooth(const glm::dvec3& d) {
  return glm::dvec3(0.5, 0.6, 0.9) * (1.0 + 0.4 * d.x + 0.3 * d.y);
}

/// A smooth sky with even discs in it.
struct Disc {
  glm::dvec3 towards;
  double degrees;
  glm::dvec3 light;
};
SkyLight discs(const std::vector<Disc>& all) {
  return [all](const glm::dvec3& d) {
    glm::dvec3 sum = smooth(d);
    for (const Disc& disc : all) {
      if (glm::dot(d, glm::normalize(disc.towards)) >= std::cos(disc.degrees * kHalfTurn / 180.0)) sum += disc.light;
    }
    return sum;
  };
}

CubeMap cubeSky(int size, const SkyLight& light) {
  CubeMap cube = cubeOf(size, 1, [&](const glm::vec3& d) { return glm::vec3(light(glm::normalize(glm::dvec3(d)))); });
  return cube;
}

void addSpread(test::KeptValues& values) {
  const glm::dvec3 hue(1.0, 0.8, 0.2);
  std::vector<Disc> many;
  for (int i = 0; i < 24; ++i) {
    const double t = 0.7 * i;
    many.push_back({{std::cos(t), std::sin(1.9 * t), std::sin(t)}, 3.0, (1e5 + 2e4 * i) * hue});
  }
  const std::pair<const char*, std::vector<Disc>> skies[] = {
      {"one", {{{0.5, 0.7, 0.9}, 4.0, 3e5 * hue}}},
      {"across the seam", {{{0.05, 0.3, -1}, 5.0, 2e5 * hue}}},
      {"at the pole", {{{0.02, 1, 0.03}, 7.0, 9e4 * hue}}},
      {"two near each other", {{{0.5, 0.7, 0.9}, 4.0, 2e5 * hue}, {{0.9, 0.7, 0.5}, 4.0, 1e6 * hue}}},
      {"beside what is bright", {{{0.5, 0.7, 0.9}, 4.0, 4e5 * hue}, {{0.5, 0.7, 0.9}, 15.0, {60000, 30000, 5000}}}},
      {"too much for one, not for the other", {{{0.5, 0.7, 0.9}, 6.0, 3e7 * hue}, {{-0.5, -0.7, 0.3}, 6.0, 1e5 * hue}}},
      {"more than there can be", many}};
  for (const auto& [label, all] : skies) {
    PictureRepairs repairs;
    ImageRgbaF image = skyOf(64, 32, discs(all));
    limitRadiance(image, repairs);
    spreadBeyondHalf(image, repairs);
    addImage(values, std::string("spread, ") + label, image);
    addRepairs(values, repairs);
    PictureRepairs ofCube;
    ofCube.beyondHalf = 1;
    CubeMap cube = cubeSky(16, discs(all));
    spreadBeyondHalf(cube, ofCube);
    for (int face = 0; face < 6; ++face) values.addTexels("  face " + std::to_string(face), cube.face(0, face), 256);
    values.add("  lost", {ofCube.lightLost});
  }
}

void addSun(test::KeptValues& values, const std::string& label, const std::optional<SkySun>& sun) {
  if (!sun) return values.add(label + ": none");
  values.add(label, {sun->towards.x, sun->towards.y, sun->towards.z, sun->irradiance.x, sun->irradiance.y,
                     sun->irradiance.z, sun->angleDegrees});
  const Light light = lightOf(*sun, 417.0);
  values.add("  light",
             {light.direction.x, light.direction.y, light.direction.z, light.intensity, light.color.x, light.color.y,
              light.color.z, light.angleDegrees, double(light.type == LightType::Directional)});
}

void addSuns(test::KeptValues& values) {
  const std::pair<const char*, std::vector<Disc>> skies[] = {
      {"a sun", {{{0.5, 0.7, 0.9}, 2.5, {4000, 3200, 1600}}}},
      {"a sun with a halo", {{{0.5, 0.7, 0.9}, 1.5, {4000, 3200, 1600}}, {{0.5, 0.7, 0.9}, 3.0, {400, 500, 900}}}},
      {"beyond half floats", {{{-0.5, 0.2, -0.9}, 2.0, {90000, 70000, 20000}}}},
      {"two, one beyond half floats",
       {{{-0.5, 0.2, -0.9}, 2.0, {3e6, 2e6, 1e6}}, {{0.5, 0.7, 0.1}, 3.0, {7e4, 7e4, 7e4}}}},
      {"behind the seam", {{{0.03, 0.1, -1}, 2.5, {4000, 3200, 1600}}}}};
  for (const auto& [label, all] : skies) {
    std::size_t beyond = 12345;
    ImageRgbaF image = skyOf(180, 90, discs(all));
    addSun(values, label, takeSun(image, beyond));
    values.add("  beyond", {double(beyond)});
    addImage(values, "  left", image, 3);
    beyond = 0;
    CubeMap cube = cubeSky(32, discs(all));
    addSun(values, std::string(label) + ", in a cube", takeSun(cube, beyond));
    values.add("  beyond", {double(beyond)});
    for (int face = 0; face < 6; ++face) values.addTexels("  face " + std::to_string(face), cube.face(0, face), 1024);
  }
}

TEST(SkyValues, EveryRepairAndEverySun) {
  test::KeptValues values;
  addRepaired(values);
  addSpread(values);
  addSuns(values);
  values.expect("unit/values/io_sky_values.txt");
}

/// The number between two, one of which makes a sun and the other not, where that changes.
double edgeBetween(double with, double without, const std::function<std::vector<Disc>(double)>& sky, int width = 180) {
  const auto isSun = [&](double value) {
    std::size_t beyond = 0;
    ImageRgbaF image = skyOf(width, width / 2, discs(sky(value)));
    return takeSun(image, beyond).has_value();
  };
  EXPECT_TRUE(isSun(with)) << with;
  EXPECT_FALSE(isSun(without)) << without;
  for (int i = 0; i < 7; ++i) {
    const double middle = 0.5 * (with + without);
    (isSun(middle) ? with : without) = middle;
  }
  return 0.5 * (with + without);
}

/// The solid angle of the texels whose middles a disc holds.
double angleOf(const glm::dvec3& towards, double degrees, int width) {
  double sum = 0.0;
  for (int y = 0; y < width / 2; ++y) {
    const double area = 2 * kHalfTurn / width *
                        (std::sin(kHalfTurn / 2 - 2 * kHalfTurn * y / width) -
                         std::sin(kHalfTurn / 2 - 2 * kHalfTurn * (y + 1) / width));
    for (int x = 0; x < width; ++x) {
      const bool inside = glm::dot(directionOf(x, y, width, width / 2), glm::normalize(towards)) >=
                          std::cos(degrees * kHalfTurn / 180.0);
      sum += inside ? area : 0.0;
    }
  }
  return sum;
}

// The rules as the documents have them: 256 times the mean, an eighth of the rest's light, 3.5 degrees, 2 % up to 7.
TEST(SkySunRules, EndWhereTheyAreSaidTo) {
  const glm::dvec3 at(0.5, 0.7, 0.9);
  // The sky's mean of its brightest channel, blue, is 0.9; the disc is grey, so that its brightest channel is blue too.
  const double sun = 0.9 * (1.0 + (0.4 * 0.5 + 0.3 * 0.7) / glm::length(at));
  const double wide = angleOf(at, 3.0, 180);
  const double contrast = edgeBetween(800.0, 200.0, [&](double light) {
    return std::vector<Disc>{{at, 3.0, glm::dvec3(light)}};
  });
  // light + sun = 256 (0.9 + light wide / 4 pi)
  EXPECT_NEAR(contrast, (256 * 0.9 - sun) / (1 - 256 * wide / (4 * kHalfTurn)), 0.02 * contrast);
  const double narrow = angleOf(at, 1.2, 180);
  const double share = edgeBetween(2000.0, 200.0, [&](double light) {
    return std::vector<Disc>{{at, 1.2, glm::dvec3(light)}};
  });
  EXPECT_NEAR(share * narrow, kHalfTurn * 0.9 / 8.0, 0.03 * kHalfTurn * 0.9 / 8.0);
  const double width = edgeBetween(
      2.5, 5.0,
      [&](double degrees) {
        return std::vector<Disc>{{at, degrees, glm::dvec3(9000.0)}};
      },
      720);
  EXPECT_NEAR(width, 3.5, 0.1);
  // A second disc as bright, as small as it may be: its light to that of the first.
  const glm::dvec3 axis = glm::normalize(glm::cross(at, glm::dvec3(0, 1, 0)));
  const auto beside = [&](double degrees) {
    const double t = degrees * kHalfTurn / 180.0;
    return std::cos(t) * glm::normalize(at) + std::sin(t) * axis;
  };
  const double first = angleOf(at, 2.0, 360), second = angleOf(beside(5.5), 0.8, 360);
  const double light = edgeBetween(
      60.0, 9000.0,
      [&](double other) {
        return std::vector<Disc>{{at, 2.0, glm::dvec3(9000.0)}, {beside(5.5), 0.8, glm::dvec3(other)}};
      },
      360);
  EXPECT_NEAR(light * second / (9000.0 * first), 0.02, 0.0015) << light;
  const double far = edgeBetween(
      9.0, 6.0,
      [&](double degrees) {
        return std::vector<Disc>{{at, 2.0, glm::dvec3(9000.0)}, {beside(degrees), 0.6, glm::dvec3(6000.0)}};
      },
      720);
  EXPECT_NEAR(far, 7.0 + 0.5 + 0.6, 0.6) << "further out nothing counts";
}

// Around the disc: what is above a 64th of the brightest belongs to it.
TEST(SkySunRules, TheDiscEndsAtASixtyFourth) {
  const glm::dvec3 at(0.5, 0.7, 0.9);
  const auto ringAfter = [&](double ring) {
    std::size_t beyond = 0;
    ImageRgbaF image = skyOf(360, 180, discs({{at, 1.0, glm::dvec3(9000.0 - ring)}, {at, 2.5, glm::dvec3(ring)}}));
    EXPECT_TRUE(takeSun(image, beyond));
    double most = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) most = std::max<double>(most, image.pixels[i]);
    return most;
  };
  EXPECT_GT(ringAfter(130.0), 129.0) << "stays";
  EXPECT_LT(ringAfter(150.0), 3.0) << "goes with the sun";
}

TEST(PictureRepairTexts, SayWhatWasDone) {
  PictureRepairs repairs;
  EXPECT_THAT(repairs.sentences(), ElementsAre());
  repairs.remarks = {"first"};
  repairs.notFinite = 1;
  repairs.negative = 2;
  repairs.beyondHalf = 3;
  EXPECT_THAT(
      repairs.sentences(),
      ElementsAre("first", "1 texel is NaN or infinite: filled in, infinity as 65504, NaN in its neighbours' hue",
                  "2 texels are negative in a channel, which counts as 0",
                  "3 texels are above 65504, the largest half float: the light was spread over the directions "
                  "around"));
  for (const auto& [lost, text] : {std::pair{1e-6, "0.1"}, {0.1234, "12.4"}, {0.5, "50"}}) {
    PictureRepairs cut;
    cut.beyondHalf = 1;
    cut.lightLost = lost;
    EXPECT_THAT(cut.sentences(), ElementsAre("1 texel is above 65504, the largest half float: " + std::string(text) +
                                             " % of the picture's light is cut off"));
  }
}

}  // namespace
}  // namespace boxprobe
