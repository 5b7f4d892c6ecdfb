// `boxprobe explain` and `render --view`: what they print and refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "filters/core/scene/surface_view.h"
#include "filters/io/image/image_file.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::SizeIs;

// The pixel's account is about the pixel that `render` writes, and its parts add up.
TEST(ExplainCommand, JsonAddsUpToTheRenderedPixel) {
  const TemporaryFolder folder;
  const std::string scene = demoScene("room"), picture = folder.path("room.exr");
  const Outcome rendered = runProgram({"render", scene, "-o", picture, "--size", "160x90", "--samples", "1"});
  ASSERT_EQ(rendered.exitStatus, 0) << rendered.err;
  const ImageRgbaF image = loadHdrImage(picture);
  const Outcome outcome = runProgram({"explain", scene, "--pixel", "80,70", "--size", "160x90", "--json", "--quiet"});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  const json e = json::parse(outcome.out);
  EXPECT_EQ(e["pixel"], json({80, 70}));
  for (int c = 0; c < 3; ++c) {
    const double pixel = static_cast<double>(image.pixels[(70 * 160 + 80) * 4 + static_cast<std::size_t>(c)]);
    const auto part = [&](const char* name) { return e[name][static_cast<std::size_t>(c)].get<double>(); };
    EXPECT_NEAR(part("color"), pixel, 2e-3 * (1.0 + pixel));
    double sum = part("direct") + part("emissive") + part("diffuse");
    if (e.contains("specular")) sum += part("specular");
    EXPECT_NEAR(sum, pixel, 2e-3 * (1.0 + pixel));
  }
  ASSERT_THAT(e["probes"], SizeIs(1));
  const json& probe = e["probes"][0];
  EXPECT_EQ(probe["name"], "room");
  EXPECT_EQ(probe["technique"], "box+none");
  const auto factors = probe["slabFactors"].get<std::vector<double>>();
  EXPECT_DOUBLE_EQ(probe["hitDistance"].get<double>(), *std::min_element(factors.begin(), factors.end()));
  double share = 0.0;
  ASSERT_FALSE(probe["lookups"].empty());
  for (const json& lookup : probe["lookups"]) share += lookup["weight"].get<double>();
  EXPECT_NEAR(share, 1.0, 1e-5);
  for (const char* key : {"positionWorld", "normalWorld", "reflectionWorld"}) EXPECT_THAT(e[key], SizeIs(3)) << key;
  EXPECT_TRUE(e["sky"].contains("weight"));
}

// A camera that looks up into the sky: nothing else is in the picture.
TEST(ExplainCommand, TheBackgroundIsSaidToBeOne) {
  const Outcome outcome = runProgram({"explain", demoScene("building"), "--pixel", "5,5", "--size", "64x36", "--set",
                                      "cameras.main.position=[0,50,0]", "--set", "cameras.main.target=[0.1,90,0]",
                                      "--set", "probes.room.faceSize=16", "--quiet"});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("No surface at this pixel"));
}

TEST(ExplainCommand, RefusesInOneLine) {
  const std::string scene = demoScene("room");
  const TemporaryFolder folder;
  const struct {
    std::vector<std::string> arguments;
    std::string mentioned;
  } cases[] = {
      {{"explain", scene, "--pixel", "160,10", "--size", "160x90"}, "outside the picture of 160 x 90"},
      {{"explain", scene, "--pixel", "10;10"}, "expected X,Y"},
      {{"explain", scene}, "--pixel is required"},
      {{"explain", scene, "--pixel", "1,1", "--camera", "none"}, "no camera of that name"},
      {{"render", scene, "-o", folder.path("a.png"), "--view", "heat"}, "there are: all, picture, hit-distance"},
      {{"render", scene, "-o", folder.path("a.png"), "--view", "face", "--range", "0,1"}, "only a view of a number"},
      {{"render", scene, "-o", folder.path("a.png"), "--view", "level", "--range", "3,1"}, "the lower first"},
      {{"render", scene, "-o", folder.path("a.png"), "--view", "level", "--range", "3,3"}, "the lower first"},
      {{"render", scene, "-o", folder.path("a.exr"), "--view", "all"}, "a sheet of all views must be a .png"},
  };
  for (const auto& c : cases) {
    const Outcome outcome = runProgram(c.arguments, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
    ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(c.mentioned));
  }
  EXPECT_THAT(folder.names(), SizeIs(0));
}

TEST(ViewCommand, LinearPictureHoldsTheNumbersAndTheSheetAllViews) {
  const TemporaryFolder folder;
  const std::string picture = folder.path("d.exr"), sheet = folder.path("all.png");
  const std::vector<std::string> small = {"--size", "96x54", "--samples", "1", "--quiet"};
  const auto render = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"render", demoScene("room")});
    arguments.insert(arguments.end(), small.begin(), small.end());
    const Outcome outcome = runProgram(arguments);
    ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  };
  render({"-o", picture, "--view", "hit-distance"});
  const ImageRgbaF image = loadHdrImage(picture);
  const Outcome explained =
      runProgram({"explain", demoScene("room"), "--pixel", "48,40", "--size", "96x54", "--json", "--quiet"});
  const double d = json::parse(explained.out)["probes"][0]["hitDistance"];
  EXPECT_NEAR(static_cast<double>(image.pixels[(40 * 96 + 48) * 4]), d, 1e-4 * d);
  render({"-o", sheet, "--view", "all"});
  const ImageRgba8 all = loadImage8(sheet);
  EXPECT_EQ(all.width, 4 * 96 + 3 * 4);
  EXPECT_EQ(all.height, static_cast<int>((surfaceViews().size() + 3) / 4) * (54 + 4) - 4);
}

}  // namespace
}  // namespace boxprobe::test
