// `render --technique reference-box|reference-scene|reference-path`: truths that agree in the room, what their files
// hold, what they refuse, and what Ctrl-C leaves.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "filters/io/image/image_file.h"
#include "filters/reference/measure/metrics.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class Reference : public ::testing::Test {
 protected:
  std::string render(const std::string& technique, const std::string& output, DisplayKind display,
                     const std::vector<std::string>& more = {}) {
    const std::string path = folder.path(output);
    std::vector<std::string> arguments = {
        "render", demoScene("room"), "-o",      path,    "--size",
        "96x54",  "--technique",     technique, "--set", "materials.floor.roughness=0.25"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    outcome = runProgram(arguments, display);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return path;
  }

  void expectRefused(const std::vector<std::string>& more, const std::string& mentioned) {
    std::vector<std::string> arguments = {"render", demoScene("room"), "-o", folder.path("refused.exr")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    outcome = runProgram(arguments, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
    ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(mentioned));
    EXPECT_THAT(folder.names(), SizeIs(0));
  }

  TemporaryFolder folder;
  Outcome outcome;
};

TEST_F(Reference, BoxAndSceneAgreeAndSayHowFarTheyAreOff) {
  const std::string scene = render("reference-scene", "scene.exr", DisplayKind::Unset, {"--json"});
  const auto json = nlohmann::json::parse(outcome.out)["reference"];
  EXPECT_EQ(json["technique"], "reference-scene");
  EXPECT_EQ(json["raysPerPixel"], 256);
  EXPECT_GT(json["standardErrorRms"].get<double>(), 0.0);
  EXPECT_GE(json["standardErrorMax"].get<double>(), json["standardErrorRms"].get<double>());
  const Imf::InputFile file(scene.c_str());
  for (const char* channel : {"R", "G", "B", "A", "standardError.R", "standardError.G", "standardError.B"}) {
    EXPECT_NE(file.header().channels().findChannel(channel), nullptr) << channel;
  }

  // As the traced scene: a first capture, in which mirrors are black.
  const std::string box =
      render("reference-box", "box.exr", DisplayKind::Inherited, {"--set", "probes.room.bounces=1"});
  const PictureError error = pictureError(loadHdrImage(box), loadHdrImage(scene));
  std::printf("  box against scene: tone-mapped RMSE %.4f, brightness %.4f\n", error.toneMappedRmse,
              error.brightnessRatio);
  // What is left are edges, which the two sample at different places in a pixel this large, and noise.
  EXPECT_LT(error.toneMappedRmse, 0.05);
  EXPECT_NEAR(error.brightnessRatio, 1.0, 0.02);
}

TEST_F(Reference, FullShowsWhatProbesDoNotSee) {
  const std::string probes = render("reference-scene", "probes.exr", DisplayKind::Unset, {"--rays", "64"});
  const std::string full = render("reference-scene", "full.exr", DisplayKind::Unset, {"--rays", "64", "--full"});
  // The mirror spheres, which the floor then reflects, are black on the second bounce.
  EXPECT_LT(pictureError(loadHdrImage(full), loadHdrImage(probes)).brightnessRatio, 0.995);
}

TEST_F(Reference, EveryBounceBringsLightAndAShareOfItIsTheSamePicture) {
  const auto traced = [this](const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"--rays", "16"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return render("reference-path", output, DisplayKind::Unset, arguments);
  };
  const ImageRgbaF direct = loadHdrImage(traced("direct.exr", {"--bounces", "0"}));
  const ImageRgbaF once = loadHdrImage(traced("once.exr", {"--bounces", "1"}));
  const std::string all = traced("all.exr", {"--bounces", "all", "--json"});
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["reference"]["bounces"], "all");
  EXPECT_LT(pictureError(direct, loadHdrImage(all)).brightnessRatio, 0.97);
  EXPECT_LT(pictureError(direct, once).brightnessRatio, pictureError(once, loadHdrImage(all)).brightnessRatio);
  for (const char* share : {"2/3", "3/3", "1/3"}) traced("bands.exr", {"--bounces", "all", "--shard", share});
  EXPECT_EQ(readFile(folder.path("bands.exr")), readFile(all));
}

// In a room of matte walls nothing reflects: the reference is the picture where both have the same diffuse light. With
// lamps in the map it has the sky's, of which no light comes through a roof here.
TEST_F(Reference, DiffuseLightIsThatOfThePicturesLampsAndLattice) {
  const auto room = [this](const std::string& output, const std::string& lamps, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {
        "render",    BOXPROBE_DATA_DIR "/../tests/truth/lit/scenes/doorway.boxprobe.json",
        "-o",        folder.path(output),
        "--size",    "106x60",
        "--samples", "4",
        "--set",     "lamps=" + lamps};
    arguments.insert(arguments.end(), more.begin(), more.end());
    outcome = runProgram(arguments, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    return loadHdrImage(folder.path(output));
  };
  const std::vector<std::string> traced = {"--technique", "reference-scene", "--rays", "4"};
  const ImageRgbaF drawn = room("drawn.exr", "shapes", {}), own = room("own.exr", "shapes", traced),
                   sky = room("sky.exr", "in-map", traced);
  const auto off = [&](const ImageRgbaF& image, double quantile) {
    std::vector<double> errors;
    for (std::size_t i = 1; i < drawn.pixels.size(); i += 4) {
      const auto truth = static_cast<double>(drawn.pixels[i]);
      errors.push_back(std::abs(static_cast<double>(image.pixels[i]) - truth) / std::max(truth, 1.0e-3));
    }
    std::sort(errors.begin(), errors.end());
    return errors[static_cast<std::size_t>(quantile * static_cast<double>(errors.size() - 1))];
  };
  std::printf("  median off by %.4f, 90 %% within %.4f; lamps in the map %.3f\n", off(own, 0.5), off(own, 0.9),
              off(sky, 0.5));
  EXPECT_LT(off(own, 0.5), 0.004);
  EXPECT_LT(off(own, 0.9), 0.03);
  EXPECT_GT(off(sky, 0.5), 0.1);
  // Shares of its rows are the same picture.
  std::vector<std::string> shared = traced;
  shared.insert(shared.end(), {"--shard", "2/2"});
  for (const char* share : {"2/2", "1/2"}) {
    shared.back() = share;
    std::vector<std::string> arguments = {"render",
                                          "-o",
                                          folder.path("bands.exr"),
                                          "--size",
                                          "106x60",
                                          "--samples",
                                          "4",
                                          BOXPROBE_DATA_DIR "/../tests/truth/lit/scenes/doorway.boxprobe.json"};
    arguments.insert(arguments.end(), shared.begin(), shared.end());
    outcome = runProgram(arguments, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  }
  EXPECT_EQ(readFile(folder.path("bands.exr")), readFile(folder.path("own.exr")));
}

TEST_F(Reference, WritesDisplayColoursToPng) {
  const ImageRgba8 image = loadImage8(render("reference-scene", "out.png", DisplayKind::Unset, {"--rays", "16"}));
  EXPECT_EQ(image.width, 96);
  EXPECT_EQ(image.height, 54);
  EXPECT_EQ(*std::max_element(image.pixels.begin(), image.pixels.end()), 255);
}

TEST_F(Reference, OneRayTellsNoError) {
  render("reference-scene", "out.exr", DisplayKind::Unset, {"--rays", "1", "--json"});
  EXPECT_TRUE(nlohmann::json::parse(outcome.out)["reference"].at("standardErrorRms").is_null());
  render("reference-path", "out.exr", DisplayKind::Unset, {"--rays", "1"});
  EXPECT_THAT(outcome.out, HasSubstr("standard error unknown from one ray"));
}

TEST_F(Reference, RefusesANameThatIsTooLongBeforeItTraces) {
  outcome = runProgram({"render", demoScene("room"), "-o", folder.path(std::string(256, 'n') + ".png"), "--technique",
                        "reference-path", "--rays", "16384"},
                       DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
  ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("choose a shorter one"));
  EXPECT_THAT(folder.names(), SizeIs(0));
}

// A share's file has a longer name than the picture.
TEST_F(Reference, RefusesANameThatIsTooLongForAShareBeforeItTraces) {
  outcome = runProgram({"render", demoScene("room"), "-o", folder.path(std::string(245, 'n') + ".png"), "--technique",
                        "reference-path", "--rays", "16384", "--shard", "1/2"},
                       DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
  ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("choose a shorter one"));
  EXPECT_THAT(folder.names(), SizeIs(0));
}

TEST_F(Reference, OneFileSpeltInTwoWaysIsNotWrittenTwice) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path("."));
  for (const std::string& other : {std::string("./q.png"), folder.path("q.png"), std::string("a/../q.png")}) {
    outcome = runProgram({"render", demoScene("room"), "-o", "q.png", "--stats", other, "--technique", "reference-path",
                          "--rays", "1", "--size", "32x18"},
                         DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2) << other << ": " << outcome.err;
    EXPECT_THAT(folder.names(), SizeIs(0)) << other;
  }
  std::filesystem::current_path(before);
}

TEST_F(Reference, RefusesWhatItHasNoUseFor) {
  expectRefused({"--rays", "64"}, "--rays 64 is for --technique");
  expectRefused({"--full"}, "--full is for --technique");
  expectRefused({"--technique", "reference-scene", "--rays", "0"}, "--rays");
  expectRefused({"--technique", "reference-scene", "--rays", "65537"}, "--rays");
  expectRefused({"--technique", "reference-box", "--full"}, "--full");
  expectRefused({"--technique", "reference-scene", "--view", "distance"}, "--view");
  expectRefused({"--technique", "reference-scene", "--probes", "off"}, "--probes");
  expectRefused({"--technique", "reference-scene", "--frames", "3"}, "--frames");
  expectRefused({"--technique", "reference-scene", "--bounces", "2"}, "--bounces 2");
  expectRefused({"--bounces", "2"}, "--bounces is for --technique reference-path");
  for (const char* bounces : {"-1", "1.5", "1001", "many"}) {
    expectRefused({"--technique", "reference-path", "--bounces", bounces}, "a whole number from 0 to 1000, or all");
  }
}

// Before the first ray there is nothing to keep: not before some are followed.
TEST_F(Reference, InterruptedLeavesWhatItHasUnderAnotherName) {
  RunningProgram program({"render", demoScene("room"), "-o", folder.path("out.exr"), "--size", "320x180", "--technique",
                          "reference-scene", "--rays", "16384", "--set", "materials.floor.roughness=0.5"},
                         DisplayKind::Unset);
  ASSERT_TRUE(program.waitForProgress(1)) << program.finish().err;
  ASSERT_TRUE(program.sendAtWork(SIGINT)) << "done before the signal";
  outcome = program.finish();
  EXPECT_EQ(outcome.exitStatus, 1) << outcome.err;
  ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_THAT(folder.names(), ElementsAre("out.exr.partial"));
  EXPECT_THAT(outcome.err, HasSubstr("out.exr.partial"));
  const std::string readable = folder.path("partial.exr");
  std::filesystem::rename(folder.path("out.exr.partial"), readable);
  EXPECT_EQ(loadHdrImage(readable).width, 320);
}

}  // namespace
}  // namespace boxprobe::test
