// Every bad input ends with exit status 2 and exactly one line that names the file and the place; no output is left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

class BadInput : public ::testing::Test {
 protected:
  /// Exit 2, one line, all of `mentioned` in it, and nothing in the folder that was not there before.
  void expectRefused(const std::vector<std::string>& arguments, const std::vector<std::string>& mentioned,
                     DisplayKind display = DisplayKind::Unset) {
    const std::vector<std::string> before = folder.names();
    const Outcome outcome = runProgram(arguments, display);
    EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("boxprobe: "));
    for (const std::string& text : mentioned) EXPECT_THAT(outcome.err, HasSubstr(text));
    EXPECT_EQ(folder.names(), before);
  }

  /// Without a display: input is looked at before the window system, so that its mistakes are named even there.
  void expectSceneRefused(const std::string& text, std::vector<std::string> mentioned) {
    folder.write("model.gltf", triangleGltf());
    const std::string path = folder.write("scene.boxprobe.json", text);
    mentioned.push_back("scene.boxprobe.json");
    expectRefused({"render", path, "-o", folder.path("out.png")}, mentioned);
    expectRefused({"info", path}, mentioned);
  }

  /// A good scene; the arguments of the command line are what is wrong.
  void expectArgumentsRefused(std::vector<std::string> arguments, const std::vector<std::string>& mentioned) {
    folder.write("model.gltf", triangleGltf());
    const std::string path = folder.write("good.boxprobe.json", scene(R"("exposure": 1)"));
    arguments.insert(arguments.begin(), {"render", path});
    expectRefused(arguments, mentioned);
  }

  static std::string scene(const std::string& members) {
    return "{\"format\": \"boxprobe-scene\", \"version\": 1, \"model\": \"model.gltf\",\n" + members + "}\n";
  }
  static std::string probe(const std::string& members) {
    return scene("\"probes\": [{\"name\": \"room\", \"origin\": [0, 0, 0],\n" + members + "}]");
  }

  TemporaryFolder folder;
};

TEST_F(BadInput, MissingScene) {
  expectRefused({"render", folder.path("none.boxprobe.json"), "-o", folder.path("out.png")}, {"none.boxprobe.json"});
  expectRefused({"info", folder.path("none.boxprobe.json")}, {"none.boxprobe.json"});
}

TEST_F(BadInput, SceneIsAFolder) {
  expectRefused({"info", folder.path("")}, {"folder"});
}

TEST_F(BadInput, SceneOfAnUnknownKind) {
  expectRefused({"info", folder.write("notes.txt", "hello")}, {"notes.txt", ".glb"});
}

TEST_F(BadInput, EmptyScene) {
  expectSceneRefused("", {});
}
TEST_F(BadInput, BinaryScene) {
  expectSceneRefused(std::string("\x00\xff\xfe{\x80", 5), {});
}
TEST_F(BadInput, MalformedJsonNamesTheLine) {
  expectSceneRefused("{\n  \"format\": \"boxprobe-scene\",\n  \"version\" 1\n}", {"3"});
}
TEST_F(BadInput, UnknownKey) {
  expectSceneRefused(probe("\"boxx\": 1"), {"probes", "boxx"});
}
TEST_F(BadInput, UnknownKeyAtTheTop) {
  expectSceneRefused(scene("\"modells\": 1"), {"modells"});
}
TEST_F(BadInput, WrongType) {
  expectSceneRefused(probe("\"faceSize\": \"large\""), {"room", "faceSize"});
}
TEST_F(BadInput, WrongVectorLength) {
  expectSceneRefused(probe("\"rotationDegrees\": [1, 2]"), {"room", "rotationDegrees"});
}
TEST_F(BadInput, NaNLiteral) {
  expectSceneRefused(scene("\"exposure\": NaN"), {"2"});
}
TEST_F(BadInput, NumberBeyondDouble) {
  expectSceneRefused(scene("\"exposure\": 1e999"), {});
}
TEST_F(BadInput, BoxMinAboveMax) {
  expectSceneRefused(probe(R"("box": {"min": [1, -1, -1], "max": [-1, 1, 1]})"), {"room", "box"});
}
TEST_F(BadInput, UnknownTechnique) {
  expectSceneRefused(probe("\"technique\": \"cone\""), {"room", "cone", "infinite"});
}
TEST_F(BadInput, TwoProbesOfOneName) {
  expectSceneRefused(scene(R"("probes": [{"name": "a"}, {"name": "a"}])"), {"probes", "a"});
}
TEST_F(BadInput, WrongFormat) {
  expectSceneRefused(R"({"format": "other", "version": 1})", {"format"});
}
TEST_F(BadInput, FutureVersion) {
  expectSceneRefused(R"({"format": "boxprobe-scene", "version": 99})", {"version"});
}

TEST_F(BadInput, MissingModel) {
  const std::string path =
      folder.write("lost.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1, "model": "lost.glb"})");
  expectRefused({"info", path}, {"lost.glb"});
}

TEST_F(BadInput, MissingSkyImage) {
  folder.write("model.gltf", triangleGltf());
  const std::string path = folder.write("sky.boxprobe.json", scene(R"("sky": {"image": "lost.exr"})"));
  expectRefused({"info", path}, {"lost.exr"});
  expectRefused({"render", path, "-o", folder.path("out.png")}, {"lost.exr"}, DisplayKind::Inherited);
}

TEST_F(BadInput, AMissingTextureIsGreyAndSaid) {
  const std::string path = folder.write("textured.gltf", triangleGltf("lost.png"));
  const Outcome info = runProgram({"info", path}, DisplayKind::Unset);
  EXPECT_EQ(info.exitStatus, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("textured.gltf: has the texture lost.png, which does not exist"));
  const Outcome render =
      runProgram({"render", path, "-o", folder.path("out.png"), "--size", "64x64"}, DisplayKind::Inherited);
  EXPECT_EQ(render.exitStatus, 0) << render.err;
  EXPECT_THAT(render.err, HasSubstr("textured.gltf: has the texture lost.png, which does not exist"));
}

TEST_F(BadInput, TextureOutsideTheModelsFolder) {
  const std::string path = folder.write("escaping.gltf", triangleGltf("../../../../etc/hostname"));
  expectRefused({"info", path}, {"escaping.gltf"});
}

TEST_F(BadInput, UnreadableModel) {
  expectRefused({"info", folder.write("noise.glb", std::string(64, 'x'))}, {"noise.glb"});
  expectRefused({"info", folder.write("half.gltf", triangleGltf().substr(0, 200))}, {"half.gltf"});
  expectRefused({"info", folder.write("empty.glb", "")}, {"empty.glb"});
}

TEST_F(BadInput, AMirrorThatIsNotPlanar) {
  expectRefused({"info", demoScene("mirror-hall"), "--set", "mirrors.pillars.enabled=true"},
                {"mirror-hall.boxprobe.json", "mirrors.pillars", "flat"});
  expectRefused(
      {"render", demoScene("mirror-hall"), "-o", folder.path("out.png"), "--set", "mirrors.figure.enabled=true"},
      {"mirror-hall.boxprobe.json", "mirrors.figure", "flat"});
  expectSceneRefused(scene(R"("mirrors": {"triangle": {"resolution": 9}})"), {"mirrors", "triangle", "resolution"});
}

TEST_F(BadInput, UnknownTechniqueOnTheCommandLine) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--technique", "cone"},
                         {"--technique", "cone", "infinite", "sphere"});
}

TEST_F(BadInput, UnknownCameraListsThoseThereAre) {
  folder.write("model.gltf", triangleGltf());
  const std::string path = folder.write("cameras.boxprobe.json", scene(R"("cameras": {"left": {}, "right": {}})"));
  expectRefused({"render", path, "-o", folder.path("out.png"), "--camera", "up"}, {"--camera", "up", "left", "right"});
}

TEST_F(BadInput, Size) {
  for (const std::string size :
       {"0x720", "1280", "1280x", "1280x720x2", "-1x720", "20000x720", "1280x720.5", "axb", ""}) {
    SCOPED_TRACE(size);
    expectArgumentsRefused({"-o", folder.path("out.png"), "--size=" + size}, {"--size"});
  }
}

TEST_F(BadInput, OutputsThatAreNoFilesOrOneFile) {
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  for (const char* kind : {".glb", ".gltf", ".obj", ".ply", ".stl", ".vtp"}) {
    ASSERT_EQ(::mkfifo(folder.path(std::string("model") + kind).c_str(), 0600), 0);
    const Outcome outcome = runProgram({"info", folder.path(std::string("model") + kind)});
    EXPECT_EQ(outcome.exitStatus, 2) << kind;
    EXPECT_THAT(outcome.err, HasSubstr(std::string("model") + kind + ": is not a file but a pipe or device"));
  }
  const std::string picture = folder.path("s.png");
  const auto refused = [&](const std::string& stats, const char* text) {
    const Outcome outcome =
        runProgram({"render", demoScene("room"), "-o", picture, "--stats", stats, "--size", "8x8", "--quiet"});
    EXPECT_EQ(outcome.exitStatus, 2);
    ASSERT_EQ(outcome.errLines().size(), 1u) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(text));
    EXPECT_FALSE(std::filesystem::exists(picture));
  };
  refused(folder.path("pipe"), "this is a pipe or device");
  refused(picture, "-o writes to this file");
  refused(folder.path("./s.png"), "-o writes to this file");
}

TEST_F(BadInput, Samples) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--samples", "3"}, {"--samples"});
}
TEST_F(BadInput, Frames) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--frames", "-1"}, {"--frames"});
}
TEST_F(BadInput, Probes) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--probes", "maybe"}, {"--probes"});
}
// A value that means nothing is not taken as none.
TEST_F(BadInput, VariablesOfTheEnvironment) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> refused = {
      {"BOXPROBE_RENDERER_TUNING", {"card", ""}},
      {"BOXPROBE_ANISOTROPY", {"0", "17", "2.5", "8x"}},
      {"BOXPROBE_TEXTURE_UNITS", {"-3", "many"}},
      {"BOXPROBE_TEXTURE_MEMORY", {"0", "4GB", "nan"}}};
  for (const auto& [name, values] : refused) {
    for (const std::string& value : values) {
      ::setenv(name.c_str(), value.c_str(), 1);
      expectArgumentsRefused({"-o", folder.path("out.png")}, {name, "\"" + value + "\"", "set it to"});
    }
    ::unsetenv(name.c_str());
  }
}
TEST_F(BadInput, UnknownFlag) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--fast"}, {"--fast"});
}
TEST_F(BadInput, NoOutput) {
  expectArgumentsRefused({}, {"--output"});
}
TEST_F(BadInput, OutputExtension) {
  expectArgumentsRefused({"-o", folder.path("out.jpg")}, {"out.jpg", ".png", ".exr"});
}
TEST_F(BadInput, OutputFolderMissing) {
  expectArgumentsRefused({"-o", folder.path("no/out.png")}, {"/no", "out.png"});
}
TEST_F(BadInput, OutputFolderIsAFile) {
  expectArgumentsRefused({"-o", folder.path("good.boxprobe.json/out.png")}, {"good.boxprobe.json"});
}
TEST_F(BadInput, OutputNotWritable) {
  expectArgumentsRefused({"-o", "/proc/out.png"}, {"/proc"});
}
TEST_F(BadInput, StatsFolderMissing) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--stats", folder.path("no/stats.json")}, {"--stats", "/no"});
}

TEST_F(BadInput, SetOfAFieldThatDoesNotExist) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--set", "probes.attic.faceSize=64"}, {"attic"});
  expectArgumentsRefused({"-o", folder.path("out.png"), "--set", "exposition=2"}, {"exposition"});
}
TEST_F(BadInput, SetWithoutAValue) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--set", "exposure"}, {"exposure"});
}
TEST_F(BadInput, SetToTheWrongType) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--set", "exposure=NaN"}, {"exposure"});
  expectArgumentsRefused({"-o", folder.path("out.png"), "--set", "exposure=[1]"}, {"exposure"});
}
TEST_F(BadInput, SetOutOfRange) {
  expectArgumentsRefused({"-o", folder.path("out.png"), "--set", "exposure=-1"}, {"--set", "exposure"});
}

TEST_F(BadInput, NoDisplay) {
  folder.write("model.gltf", triangleGltf());
  const std::string path = folder.write("good.boxprobe.json", scene(R"("exposure": 1)"));
  const std::vector<std::string> render = {"render", path, "-o", folder.path("out.png")};
  std::vector<std::string> withX = render;
  withX.insert(withX.end(), {"--offscreen", "x"});
  expectRefused(withX, {"no display", "DISPLAY", "xvfb-run"}, DisplayKind::Unset);
  expectRefused(render, {"no display", ":9876", "xvfb-run"}, DisplayKind::Unreachable);
  expectRefused({path}, {"no display", "DISPLAY"}, DisplayKind::Unset);
  expectRefused({path}, {"no display", ":9876"}, DisplayKind::Unreachable);
}

TEST_F(BadInput, FlagOfTheProgram) {
  expectRefused({"--frobnicate"}, {"--frobnicate", "--help"});
}

TEST_F(BadInput, FileNameWithALineBreakStaysOneLine) {
  expectRefused({"info", folder.path("two\nlines.glb")}, {"lines.glb"});
}

TEST_F(BadInput, TonesThatAreNone) {
  expectSceneRefused(R"({"format": "boxprobe-scene", "version": 1, "model": "model.gltf", "tone": "filmic"})",
                     {"tone", "filmic", "neutral"});
  expectSceneRefused(R"({"format": "boxprobe-scene", "version": 1, "model": "model.gltf", "exposure": 1e30})",
                     {"exposure", "1e+30"});
}

}  // namespace
}  // namespace boxprobe::test
