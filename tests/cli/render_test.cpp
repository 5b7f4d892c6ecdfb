// `boxprobe render` draws what the scene and its arguments say. Needs a display (CTest starts a virtual one).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "app/cli/options/subcommand.h"
#include "app/session/offscreen_choice.h"
#include "filters/io/image/image_file.h"
#include "filters/math/shared/display_math.h"
#include "tests/cli/program.h"
#include "tests/support/shown_light.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Set for the programs that are started while this lives.
class EnvironmentVariable {
 public:
  EnvironmentVariable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value, 1);
  }
  ~EnvironmentVariable() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  EnvironmentVariable(const EnvironmentVariable&) = delete;
  EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

class Render : public ::testing::Test {
 protected:
  /// Renders data/scenes/SCENE at 160 x 90 into the folder; returns the path of the picture.
  std::string render(const std::string& scene, const std::string& output, const std::vector<std::string>& more = {}) {
    std::string path = folder.path(output);
    std::vector<std::string> arguments = {"render", demoScene(scene), "-o", path, "--size", "160x90"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    outcome = runProgram(arguments);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return path;
  }

  json renderStats(const std::string& scene, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"--stats", folder.path("stats.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    render(scene, "stats.png", arguments);
    return json::parse(readFile(folder.path("stats.json")));
  }

  static std::string firstProbe(const std::string& scene) {
    const Outcome info = runProgram({"info", "--json", demoScene(scene)}, DisplayKind::Unset);
    return json::parse(info.out)["probes"][0]["name"].get<std::string>();
  }

  TemporaryFolder folder;
  Outcome outcome;
};

std::size_t differentPixels(const ImageRgba8& a, const ImageRgba8& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4)
    count += !std::equal(&a.pixels[i], &a.pixels[i] + 4, &b.pixels[i]);
  return count;
}

// From here llvmpipe meets footprints in the floor so thin that its anisotropic sampling took minutes over the frame.
TEST_F(Render, ACameraCloseToTheFloorIsDrawnAsFastAsAnyOther) {
  const std::string path = folder.path("floor.png");
  const Outcome drawn =
      runProgram({"render", demoScene("building"), "-o", path, "--size", "1115x908", "--samples", "1", "--set",
                  "cameras.main.position=[-2.107173441870109,0.41330816937452697,0.49739732604817877]"});
  EXPECT_EQ(drawn.exitStatus, 0) << drawn.err;
  EXPECT_EQ(loadImage8(path).width, 1115);
}

TEST_F(Render, PngHasTheSizeAskedForAndAPictureInIt) {
  for (const char* scene : {"building", "room"}) {
    SCOPED_TRACE(scene);
    const ImageRgba8 image = loadImage8(render(scene, "out.png"));
    EXPECT_EQ(image.width, 160);
    EXPECT_EQ(image.height, 90);
    std::set<std::vector<std::uint8_t>> colours;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) colours.emplace(&image.pixels[i], &image.pixels[i] + 3);
    EXPECT_GT(colours.size(), 100u);
  }
}

TEST_F(Render, LeavesTheOutputAlone) {
  render("room", "out.png");
  EXPECT_THAT(folder.names(), ElementsAre("out.png"));
}

TEST_F(Render, SameInputSameBytes) {
  const std::string first = readFile(render("building", "first.png"));
  EXPECT_GT(first.size(), 1000u);
  EXPECT_TRUE(first == readFile(render("building", "second.png")));
  EXPECT_TRUE(readFile(render("room", "first.exr")) == readFile(render("room", "second.exr")));
}

TEST_F(Render, WithoutADisplayEglDrawsTheSamePicture) {
  for (const std::string output : {"out.png", "out.exr"}) {
    const std::string onX = readFile(render("building", output));
    const std::string path = folder.path("egl-" + output);
    for (const char* kind : {"auto", "egl"}) {
      const Outcome done = runProgram(
          {"render", demoScene("building"), "-o", path, "--size", "160x90", "--offscreen", kind}, DisplayKind::Unset);
      ASSERT_EQ(done.exitStatus, 0) << done.err;
      EXPECT_TRUE(readFile(path) == onX) << kind << " " << output;
    }
  }
}

TEST_F(Render, TheSamePictureHoweverTheRendererIsTuned) {
  const auto drawn = [this](const char* kind) {
    return loadImage8(render("room", std::string(kind) + ".png", {"--renderer-tuning", kind}));
  };
  const ImageRgba8 onCpu = drawn("cpu"), onCard = drawn("gpu");
  ASSERT_EQ(onCpu.pixels.size(), onCard.pixels.size());
  for (std::size_t i = 0; i < onCpu.pixels.size(); ++i) {
    ASSERT_NEAR(int{onCpu.pixels[i]}, int{onCard.pixels[i]}, 1) << i;
  }
  CLI::App command;  // what it does, which pictures cannot tell
  addTuningOption(command);
  command.parse("--renderer-tuning gpu");
  EXPECT_STREQ(std::getenv("BOXPROBE_RENDERER_TUNING"), "gpu");
  ::unsetenv("BOXPROBE_RENDERER_TUNING");
  const Outcome wrong =
      runProgram({"render", demoScene("room"), "-o", folder.path("x.png"), "--renderer-tuning", "card"});
  EXPECT_EQ(wrong.exitStatus, 2);
  EXPECT_THAT(wrong.errLines(), SizeIs(1)) << wrong.err;
  EXPECT_THAT(wrong.err, HasSubstr("--renderer-tuning"));
}

TEST_F(Render, AnOpenGlThatIsTooOldIsNamed) {
  EXPECT_EQ(missingFromOpenGl(45, true), "");
  EXPECT_EQ(missingFromOpenGl(31, true), "OpenGL 3.1 (3.2 is needed)");
  EXPECT_THAT(missingFromOpenGl(32, false), HasSubstr("RGBA32F"));
  const EnvironmentVariable old("MESA_GL_VERSION_OVERRIDE", "3.1");
  const Outcome done =
      runProgram({"render", demoScene("room"), "-o", folder.path("old.png"), "--offscreen", "egl"}, DisplayKind::Unset);
  EXPECT_EQ(done.exitStatus, 2);
  EXPECT_THAT(done.errLines(), SizeIs(1)) << done.err;
  EXPECT_THAT(done.err, HasSubstr("EGL offers no OpenGL 3.2"));
}

// CMakePresets.json lets the tests run without the optimiser of Mesa's software renderer.
TEST_F(Render, TheDriversOptimizerChangesNoPixel) {
  const EnvironmentVariable fresh("MESA_SHADER_CACHE_DISABLE", "true");  // neither takes what the other compiled
  const auto drawn = [&](const char* perf, const char* file) {
    const EnvironmentVariable set("GALLIVM_PERF", perf);
    return readFile(render("building", file));
  };
  const std::string optimized = drawn("", "with.exr");
  EXPECT_GT(optimized.size(), 1000u);
  EXPECT_TRUE(optimized == drawn("nopt", "without.exr"));
}

TEST_F(Render, ExrIsTheLinearSideOfThePng) {
  // One sample per pixel: averaging happens before the display curve in one and after it in the other.
  const ImageRgbaF linear = loadHdrImage(render("room", "out.exr", {"--samples", "1"}));
  const ImageRgba8 display = loadImage8(render("room", "out.png", {"--samples", "1"}));
  ASSERT_EQ(linear.width, 160);
  ASSERT_EQ(linear.height, 90);
  std::size_t compared = 0;
  std::size_t agreeing = 0;
  float brightest = 0.0f;
  for (std::size_t i = 0; i < linear.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    brightest = std::max(brightest, linear.pixels[i]);
    const double expected = 255.0 * shownLight(linear.pixels[i]);
    ++compared;
    if (std::abs(expected - display.pixels[i]) <= 1.5) ++agreeing;
  }
  EXPECT_GT(brightest, 1.0f) << "the lamp's radiance is not clipped";
  EXPECT_GT(agreeing, compared * 99 / 100) << agreeing << " of " << compared;
}

TEST_F(Render, SetChangesThePicture) {
  const ImageRgba8 mirror = loadImage8(render("room", "mirror.png", {"--set", "materials.floor.roughness=0"}));
  const ImageRgba8 rough = loadImage8(render("room", "rough.png", {"--set", "materials.floor.roughness=0.6"}));
  EXPECT_GT(differentPixels(mirror, rough), 500u);
}

// A tone is of display colours alone, drawn by the shader as the library has it.
TEST_F(Render, TonesMapWhatIsShown) {
  const auto bytesOf = [&](const std::string& tone) {
    return loadImage8(render("room", "shown.png", {"--samples", "1", "--set", "exposure=2.3", "--tone", tone}));
  };
  const std::vector<std::string> linearly = {"--samples", "1", "--set", "exposure=2.3", "--tone"};
  const auto lightOf = [&](const std::string& tone) {
    std::vector<std::string> arguments = linearly;
    arguments.push_back(tone);
    return loadHdrImage(render("room", "light.exr", arguments));
  };
  const ImageRgbaF light = lightOf("none");
  ImageRgba8 before = bytesOf("none");
  const std::pair<const char*, Tone> tones[] = {{"neutral", Tone::Neutral}, {"agx", Tone::Agx}, {"aces", Tone::Aces}};
  for (const auto& [name, tone] : tones) {
    EXPECT_TRUE(lightOf(name).pixels == light.pixels) << name;
    const ImageRgba8 shown = bytesOf(name);
    EXPECT_GT(differentPixels(shown, before), 500u) << name;
    std::size_t off = 0;
    for (std::size_t i = 0; i < shown.pixels.size(); i += 4) {
      const glm::vec3 mapped =
          toneMapped(2.3f * glm::vec3(light.pixels[i], light.pixels[i + 1], light.pixels[i + 2]), tone);
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = 255.0 * shownLight(mapped[static_cast<int>(c)]);
        if (std::abs(expected - shown.pixels[i + c]) > 1.5) ++off;
      }
    }
    EXPECT_LT(off, shown.pixels.size() / 100) << name;
    before = shown;
  }
}

// Of a bare object; light, and so linear pictures, knows nothing of it.
TEST_F(Render, AGroundShadowDarkensTheGroundAlone) {
  const std::string model = BOXPROBE_SOURCE_DIR "/tests/unit/models/torus.glb";
  const auto drawn = [&](const std::string& output, const std::string& shadow) {
    const std::string path = folder.path(output);
    outcome = runProgram({"render", model, "-o", path, "--size", "160x90", "--set", "groundShadow=" + shadow});
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    return path;
  };
  const ImageRgba8 with = loadImage8(drawn("with.png", "true")), without = loadImage8(drawn("without.png", "false"));
  EXPECT_TRUE(loadHdrImage(drawn("with.exr", "true")).pixels == loadHdrImage(drawn("without.exr", "false")).pixels);
  std::size_t darker = 0, brighter = 0, lowest = 0;
  for (std::size_t i = 0; i < with.pixels.size(); i += 4) {
    const int change = with.pixels[i + 1] - without.pixels[i + 1];
    if (change < -3) ++darker, lowest = std::max(lowest, i / 4 / 160);
    if (change > 0) ++brighter;
  }
  EXPECT_GT(darker, 100u);
  EXPECT_EQ(brighter, 0u);
  EXPECT_GT(lowest, 45u) << "below the middle";
}

TEST_F(Render, ABackgroundIsThePicturesAlone) {
  const auto with = [&](const std::string& background, const std::string& output) {
    return render("building", output, {"--samples", "1", "--set", "background=" + background});
  };
  const ImageRgba8 sky = loadImage8(with("environment", "sky.png")), plain = loadImage8(with("plain", "plain.png"));
  EXPECT_GT(differentPixels(sky, plain), 100u);
  EXPECT_TRUE(loadHdrImage(with("environment", "sky.exr")).pixels == loadHdrImage(with("plain", "plain.exr")).pixels);
}

// One colour is the display's own: its byte does not change with exposure and tone, and surfaces stay as they are.
TEST_F(Render, ABackgroundOfOneColourIsThatColour) {
  const auto with = [&](const std::string& output, std::vector<std::string> sets) {
    std::vector<std::string> arguments = {"--samples", "1", "--set", "background=color"};
    for (std::string& set : sets) arguments.insert(arguments.end(), {"--set", std::move(set)});
    return render("building", output, arguments);
  };
  // srgb(0.0331) = 51, srgb(0.2159) = 128, srgb(0.6038) = 204
  const std::string mixed = "backgroundColor=[0.0331,0.2159,0.6038]";
  const ImageRgba8 plain = loadImage8(with("mixed.png", {mixed}));
  const ImageRgba8 toned = loadImage8(with("toned.png", {mixed, "tone=neutral", "exposure=0.3"}));
  const ImageRgba8 other = loadImage8(with("other.png", {"backgroundColor=[0.2159,0.0331,0.0331]"}));
  const auto near = [](const ImageRgba8& image, std::size_t at, int red, int green, int blue) {
    const int channels[] = {red, green, blue};
    for (std::size_t c = 0; c < 3; ++c) {
      if (std::abs(static_cast<int>(image.pixels[at + c]) - channels[c]) > 1) return false;
    }
    return true;
  };
  std::size_t behind = 0, before = 0;
  for (std::size_t i = 0; i < plain.pixels.size(); i += 4) {
    if (near(plain, i, 51, 128, 204) && near(other, i, 128, 51, 51)) {
      ++behind;
      EXPECT_TRUE(near(toned, i, 51, 128, 204)) << i;
    } else {
      before += std::equal(&plain.pixels[i], &plain.pixels[i] + 3, &other.pixels[i]) ? 1 : 0;
    }
  }
  EXPECT_GT(behind, 100u);
  EXPECT_GT(before, behind) << "what stands before it";
}

TEST_F(Render, SetOfAVector) {
  const std::string probe = firstProbe("room");
  const ImageRgba8 before = loadImage8(render("room", "before.png", {"--set", "materials.floor.roughness=0"}));
  const ImageRgba8 after = loadImage8(render(
      "room", "after.png", {"--set", "materials.floor.roughness=0", "--set", "probes." + probe + ".box.max=[9,9,9]"}));
  EXPECT_GT(differentPixels(before, after), 500u);
}

TEST_F(Render, TechniqueChangesThePicture) {
  const std::vector<std::string> floor = {"--set", "materials.floor.roughness=0", "--technique"};
  const auto with = [&](const std::string& id) {
    std::vector<std::string> arguments = floor;
    arguments.push_back(id);
    return loadImage8(render("room", "technique.png", arguments));
  };
  const ImageRgba8 box = with("box");
  EXPECT_GT(differentPixels(box, with("infinite")), 500u);
  EXPECT_GT(differentPixels(box, with("sphere")), 500u);
  EXPECT_GT(differentPixels(box, with("normal")), 500u);
  EXPECT_EQ(differentPixels(box, with("box+none")), 0u);
}

TEST_F(Render, StatsHaveTheDocumentedFields) {
  const json stats = renderStats("room", {"--frames", "3"});
  const json& counters = stats["counters"];
  EXPECT_EQ(counters["facesCaptured"], 12) << "two bounces";
  EXPECT_GE(counters["levelsFiltered"], 1);
  EXPECT_GE(counters["programsCompiled"], 1);
  EXPECT_GE(counters["renders"], 4);
  EXPECT_GT(counters["drawsByProbeCount"][1], 0);
  const json& times = stats["times"];
  EXPECT_GT(times["captureCpuSeconds"], 0.0);
  EXPECT_GT(times["prefilterCpuSeconds"], 0.0);
  EXPECT_GT(times["startToFirstFrameCpuSeconds"],
            times["captureCpuSeconds"].get<double>() + times["prefilterCpuSeconds"].get<double>());
  EXPECT_EQ(times["frames"], 3);
  EXPECT_GT(times["frameCpuSecondsMin"], 0.0);
  EXPECT_GE(times["frameCpuSecondsMedian"], times["frameCpuSecondsMin"]);
  EXPECT_GT(stats["memoryBytes"]["probes"], 6 * 256 * 256 * 8);
  EXPECT_GT(stats["memoryBytes"]["peakResident"], stats["memoryBytes"]["probes"]);
  EXPECT_NE(stats["gl"]["renderer"], "");
  EXPECT_NE(stats["gl"]["version"], "");
  const bool onCpu = stats["gl"]["renderer"].get<std::string>().find("llvmpipe") != std::string::npos;
  EXPECT_EQ(stats["gl"]["anisotropy"], onCpu ? 1 : 8);
}

TEST_F(Render, EachBounceCapturesSixFaces) {
  const json stats = renderStats("room", {"--set", "probes." + firstProbe("room") + ".bounces=3"});
  EXPECT_EQ(stats["counters"]["facesCaptured"], 18);
}

TEST_F(Render, ProbesOffCapturesNothing) {
  const json stats = renderStats("room", {"--probes", "off"});
  EXPECT_EQ(stats["counters"]["facesCaptured"], 0);
  EXPECT_EQ(stats["counters"]["levelsFiltered"], 0);
  const ImageRgba8 off = loadImage8(folder.path("stats.png"));
  EXPECT_GT(differentPixels(off, loadImage8(render("room", "on.png"))), 500u);
}

TEST_F(Render, InfoForetellsTheMemoryOfTheProbes) {
  // One bounce: of more, the capture that the last one is lit by is kept beside it, for edits.
  const json stats = renderStats("room", {"--set", "probes.room.bounces=1"});
  const json info = json::parse(runProgram({"info", "--json", demoScene("room")}, DisplayKind::Unset).out);
  double foretold = 0.0;
  for (const json& probe : info["probes"]) foretold += probe["textureBytes"].get<double>();
  const double skyBytes = stats["memoryBytes"]["probes"].get<double>() - foretold;
  EXPECT_GE(skyBytes, 0.0);
  EXPECT_LT(skyBytes, 300e3) << "the sky's own map, 64 texels a face, is all that comes on top";
}

TEST_F(Render, JsonPrintsTheStats) {
  render("room", "out.png", {"--json"});
  const json stats = json::parse(outcome.out);
  EXPECT_EQ(stats["counters"]["facesCaptured"], 12) << "two bounces";
}

TEST_F(Render, QuietPrintsNothing) {
  const std::string path = render("room", "out.png", {"--quiet", "--set", "materials.nothing.roughness=0.5"});
  EXPECT_EQ(outcome.out, "");
  EXPECT_GT(readFile(path).size(), 1000u);
}

TEST_F(Render, WarnsOnceOfAnOverrideThatNamesNothing) {
  outcome = runProgram({"render", demoScene("room"), "-o", folder.path("out.png"), "--size", "32x32", "--set",
                        "materials.nothing.roughness=0.5"});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  ASSERT_EQ(outcome.errLines().size(), 1u) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("boxprobe: warning: materials.nothing"));
}

TEST_F(Render, BareModel) {
  const std::string model = folder.write("model.gltf", triangleGltf());
  outcome = runProgram({"render", model, "-o", folder.path("out.png"), "--size", "64x48"});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  const ImageRgba8 image = loadImage8(folder.path("out.png"));
  constexpr std::size_t centre = std::size_t{4} * (24 * 64 + 32);
  EXPECT_FALSE(std::equal(&image.pixels[0], &image.pixels[3], &image.pixels[centre]))
      << "the triangle stands before the sky";
}

TEST_F(Render, SceneWithoutProbesShowsTheSky) {
  folder.write("model.gltf", triangleGltf());
  const std::string scene = folder.write("sky.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1,
      "model": "model.gltf", "sky": {"color": [0.25, 0.5, 0.75]},
      "cameras": {"away": {"position": [0, 0, 5], "target": [0, 0, 9]}}})");
  outcome = runProgram({"render", scene, "-o", folder.path("out.exr"), "--size", "8x8"});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  const ImageRgbaF image = loadHdrImage(folder.path("out.exr"));
  EXPECT_NEAR(image.pixels[0], 0.25, 2e-3);
  EXPECT_NEAR(image.pixels[1], 0.50, 2e-3);
  EXPECT_NEAR(image.pixels[2], 0.75, 2e-3);
}

TEST_F(Render, FramesOfAnAnimatedTechniqueAreAveraged) {
  const std::string probe = "probes." + firstProbe("room") + ".";
  const std::vector<std::string> noisy = {"--technique", "raytraced",
                                          "--samples",   "1",
                                          "--set",       "materials.floor.roughness=0.4",
                                          "--set",       probe + "faceSize=32",
                                          "--set",       probe + "parameters={\"samples\":1,\"animated\":true}"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), noisy.begin(), noisy.end());
    return more;
  };
  const ImageRgbaF one = loadHdrImage(render("room", "one.exr", with({})));
  const ImageRgbaF mean = loadHdrImage(render("room", "mean.exr", with({"--frames", "64"})));
  const json stats = renderStats("room", with({"--frames", "64"}));
  EXPECT_EQ(stats["times"]["frames"], 64);
  EXPECT_EQ(stats["counters"]["renders"], 64);
  const ImageRgba8 shown = loadImage8(folder.path("stats.png"));
  double noise = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const auto display = [](float x) { return 255.0 * shownLight(x); };
    noise = std::max(noise, std::abs(display(one.pixels[i]) - display(mean.pixels[i])));
    difference = std::max(difference, std::abs(display(mean.pixels[i]) - shown.pixels[i]));
  }
  EXPECT_GT(noise, 30.0) << "a frame of one ray is far from the mean";
  EXPECT_LE(difference, 1.0) << "PNG and EXR show the same mean";
}

}  // namespace
}  // namespace boxprobe::test
