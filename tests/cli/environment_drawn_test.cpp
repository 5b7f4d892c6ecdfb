// Pictures of the surroundings through the whole program: a file is written here, the program looks at it in one
// direction, and the right radiance is known.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "filters/io/image/image_file.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr double kPi = 3.14159265358979323846;

class DrawnEnvironment : public ::testing::Test {
 protected:
  /// The radiance that the program draws in a direction of the sky.
  glm::vec3 seen(const std::string& picture, const glm::dvec3& direction, const std::vector<std::string>& more = {}) {
    const json scene = {{"format", "boxprobe-scene"},
                        {"version", 1},
                        {"models", {{{"file", "far.gltf"}, {"translation", {0, -500, 0}}}}},
                        {"sky", {{"image", picture}}},
                        {"cameras",
                         {{"c",
                           {{"position", {0, 0, 0}},
                            {"target", {direction.x, direction.y, direction.z}},
                            {"verticalFovDegrees", 1}}}}}};
    folder.write("far.gltf", triangleGltf());
    std::vector<std::string> arguments = {
        "render", folder.write("s.boxprobe.json", scene.dump()), "-o", folder.path("o.exr"), "--size", "8x8"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    const ImageRgbaF image = loadHdrImage(folder.path("o.exr"));
    const float* p = &image.pixels[4 * (4 * 8 + 4)];
    return {p[0], p[1], p[2]};
  }

  void writeExr(
      const std::string& name, const Imath::Box2i& display, const Imath::Box2i& data,
      const std::function<glm::vec3(int, int)>& paint,
      const std::function<void(Imf::Header&)>& header = [](Imf::Header&) {}) {
    Imf::Header head(display, data);
    header(head);
    std::vector<float> values[3];
    for (int y = data.min.y; y <= data.max.y; ++y) {
      for (int x = data.min.x; x <= data.max.x; ++x) {
        for (int c = 0; c < 3; ++c) values[c].push_back(paint(x, y)[c]);
      }
    }
    const char* const names[3] = {"R", "G", "B"};
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 3; ++c) {
      head.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
      buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, values[c].data(), data));
    }
    Imf::OutputFile out(folder.path(name).c_str(), head);
    out.setFrameBuffer(buffer);
    out.writePixels(data.max.y - data.min.y + 1);
  }

  TemporaryFolder folder;
};

/// Towards the middle of a texel of a latitude-longitude map of 16 x 8: its middle is +Z, its left quarter +X.
glm::dvec3 towards(int x, int y) {
  const double longitude = kPi - 2 * kPi * (x + 0.5) / 16, latitude = kPi / 2 - kPi * (y + 0.5) / 8;
  return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
}

void expectLight(const glm::vec3& got, const glm::dvec3& right) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], right[c], 0.01 * std::max(right[c], 0.1)) << c;
}

TEST_F(DrawnEnvironment, ARadiancePictureByItsHeader) {
  // Columns from the right, each from the bottom; twice as bright as the light was, in old run lengths.
  std::string bytes = "#?RADIANCE\nEXPOSURE=2\n\n-X 16 +Y 8\n";
  for (int x = 15; x >= 0; --x) {
    const char red = static_cast<char>(128 + 6 * x);
    bytes += std::string{red, '\x40', '\x20', '\x82'} + std::string("\1\1\1\2", 4);  // rows 7, 6, 5
    bytes += std::string{red, '\x30', '\x10', '\x81'} + std::string("\1\1\1\4", 4);  // rows 4 to 0
  }
  folder.write("a.hdr", bytes);
  expectLight(seen("a.hdr", towards(3, 6)), {(128 + 18) / 256.0 * 4 / 2, 0.5, 0.25});
  expectLight(seen("a.hdr", towards(11, 2)), {(128 + 66) / 256.0 * 2 / 2, 0.1875, 0.0625});
}

TEST_F(DrawnEnvironment, AnExrInItsWindowAndColours) {
  writeExr(
      "a.exr", Imath::Box2i({0, 0}, {15, 7}), Imath::Box2i({4, 0}, {11, 7}),
      [](int, int) { return glm::vec3(0.8f, 1.1f, 1.7f); },
      [](Imf::Header& header) {
        Imf::addChromaticities(header, {{.708f, .292f}, {.17f, .797f}, {.131f, .046f}, {.3127f, .329f}});
      });
  // ITU-R BT.2087.
  expectLight(seen("a.exr", towards(9, 3)),
              {1.660491 * 0.8 - 0.587641 * 1.1 - 0.072850 * 1.7, -0.124550 * 0.8 + 1.132900 * 1.1 - 0.008349 * 1.7,
               -0.018151 * 0.8 - 0.100579 * 1.1 + 1.118730 * 1.7});
  expectLight(seen("a.exr", towards(1, 3)), {0, 0, 0});
}

TEST_F(DrawnEnvironment, ACrossFromInsideAndASkyThatIsTurned) {
  // As photographed by a viewer who faces +Z: ahead white, to the right red, to the left blue.
  writeExr("a.exr", Imath::Box2i({0, 0}, {31, 23}), Imath::Box2i({0, 0}, {31, 23}), [](int x, int y) {
    const glm::vec3 level[4] = {{0, 0, 1}, {1, 1, 1}, {1, 0, 0}, {0, 1, 0}};
    return y / 8 == 1 ? level[x / 8] : glm::vec3(0.5f);
  });
  const glm::dvec3 right(-1, 0, 0);
  expectLight(seen("a.exr", right, {"--set", "sky.cubeView=inside"}), {1, 0, 0});
  expectLight(seen("a.exr", right), {0, 0, 1});
  // 90 degrees take what is ahead, at +Z, to +X, and so what was right of it ahead.
  expectLight(seen("a.exr", {0, 0, 1}, {"--set", "sky.cubeView=inside", "--set", "sky.rotationDegrees=90"}), {1, 0, 0});
  const Outcome info = runProgram(
      {"info", folder.path("s.boxprobe.json"), "--set", "sky.cubeView=inside", "--set", "sky.rotationDegrees=90"},
      DisplayKind::Unset);
  EXPECT_THAT(info.out, HasSubstr("a cross seen from inside, turned by 90"));
}

TEST_F(DrawnEnvironment, InfoNamesWhatIsNotAsTheFileHasIt) {
  writeExr("a.exr", Imath::Box2i({0, 0}, {15, 7}), Imath::Box2i({0, 0}, {15, 7}), [](int x, int y) {
    if (x == 3 && y == 2) return glm::vec3(std::nanf(""), 1, 2);
    return x == 9 && y == 2 ? glm::vec3(1e9f) : glm::vec3(1.0f);
  });
  const json scene = {{"format", "boxprobe-scene"},
                      {"version", 1},
                      {"sky", {{"image", "a.exr"}}},
                      {"model", "far.gltf"},
                      {"probes", {{{"name", "p"}, {"mode", "custom"}, {"image", "a.exr"}}}}};
  folder.write("far.gltf", triangleGltf());
  const Outcome info =
      runProgram({"info", "--json", folder.write("s.boxprobe.json", scene.dump())}, DisplayKind::Unset);
  ASSERT_EQ(info.exitStatus, 0) << info.err;
  const json report = json::parse(info.out);
  int sky = 0, probe = 0;
  for (const std::string line : report["warnings"]) {
    sky += line.rfind("sky.image: 1 texel is ", 0) == 0 ? 1 : 0;
    probe += line.rfind("probes.p.image: 1 texel is ", 0) == 0 ? 1 : 0;
  }
  EXPECT_EQ(sky, 2);
  EXPECT_EQ(probe, 2);
  EXPECT_EQ(report["probes"][0]["imageLayout"], "latlong");
}

}  // namespace
}  // namespace boxprobe::test
