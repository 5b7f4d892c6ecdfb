// `boxprobe bake`: files, a second run that does nothing, Ctrl-C and going on, and render using what was baked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Json = nlohmann::json;

/// The room with two probes of two bounces, in a folder of its own.
Json twoProbeRoom() {
  Json scene = Json::parse(readFile(demoScene("room")));
  scene["model"] = std::string(BOXPROBE_DATA_DIR) + "/scenes/room.glb";
  scene["probes"][0]["faceSize"] = 32;
  scene["probes"][0]["bounces"] = 2;
  scene["probes"].push_back(scene["probes"][0]);
  scene["probes"][1]["name"] = "second";
  scene["probes"][1]["origin"] = {-2, 1, 1};
  return scene;
}

Json counters(const Outcome& outcome) {
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  return Json::parse(outcome.out)["counters"];
}

TEST(Bake, ASecondRunDoesNothingAndRenderCapturesNothing) {
  const TemporaryFolder folder;
  Json scene = twoProbeRoom();
  const std::string path = folder.write("room.boxprobe.json", scene.dump());
  const std::string stats = folder.path("stats.json");
  const Outcome first = runProgram({"bake", path, "--stats", stats});
  EXPECT_EQ(first.exitStatus, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("second.exr"));
  const Json cost = Json::parse(readFile(stats));
  EXPECT_EQ(cost["times"]["bounces"][0]["faces"], 12);
  EXPECT_GT(cost["times"]["bounces"][1]["cpuSeconds"], 0.0);
  EXPECT_EQ(cost["times"]["bounces"][2]["faces"], 0);
  const std::string before = readFile(folder.path("room.probes/second.exr"));

  // What is not captured may change; another folder shows that the default one was beside the scene.
  scene["exposure"] = 0.7;
  folder.write("room.boxprobe.json", scene.dump());
  const Json second = counters(runProgram({"bake", path, "--json"}));
  EXPECT_EQ(second["facesCaptured"], 0);
  EXPECT_EQ(second["levelsFiltered"], 0);
  EXPECT_EQ(readFile(folder.path("room.probes/second.exr")), before);

  const Json drawn = counters(runProgram({"render", path, "-o", folder.path("a.png"), "--size", "64x36", "--json"}));
  EXPECT_EQ(drawn["facesCaptured"], 0);
  EXPECT_EQ(drawn["skyFacesCaptured"], 0);
  EXPECT_EQ(drawn["levelsFiltered"], 0);
  EXPECT_EQ(drawn["mapsLoaded"], 3);

  const Json one = counters(runProgram({"bake", path, "--set", "probes.second.samplesPerPixel=1", "--probe", "second",
                                        "-o", folder.path("x"), "--json"}));
  EXPECT_GT(one["facesCaptured"], 0);
  const Json moved = counters(runProgram(
      {"bake", path, "--set", "probes.room.box.max=[4,3.2,3]", "--probe", "second", "-o", folder.path("y"), "--json"}));
  EXPECT_GT(moved["facesCaptured"], 0) << "its second bounce shows what lights by that box";
}

TEST(Bake, ADamagedFileIsMadeAgainTheSkysAlone) {
  const TemporaryFolder folder;
  const std::string path = folder.write("room.boxprobe.json", twoProbeRoom().dump());
  EXPECT_EQ(runProgram({"bake", path, "--quiet"}).exitStatus, 0);
  for (const char* name : {"second.exr", "_sky.exr"}) {
    const std::string file = folder.path(std::string("room.probes/") + name), before = readFile(file);
    std::filesystem::resize_file(file, 1000);
    const Outcome again = runProgram({"bake", path});
    EXPECT_EQ(again.exitStatus, 0) << again.err;
    EXPECT_THAT(again.err, HasSubstr(std::string(name) + ": is "));
    EXPECT_THAT(again.out, HasSubstr(" 1 file(s) written")) << name;
    EXPECT_EQ(readFile(file), before) << name;
  }
  const Outcome idle = runProgram({"bake", path});
  EXPECT_THAT(idle.errLines(), IsEmpty()) << idle.err;
  EXPECT_THAT(idle.out, HasSubstr(" 0 file(s) written"));
}

TEST(Bake, StoppedWorkLeavesWholeFilesAndGoesOn) {
  const TemporaryFolder folder;
  const std::string out = folder.path("probes");
  std::vector<std::string> arguments = {"bake",  demoScene("room"),           "-o",    out,
                                        "--set", "probes.room.faceSize=1024", "--set", "probes.room.bounces=5"};
  RunningProgram program(arguments);
  ASSERT_TRUE(program.waitUntilHandling(SIGINT));
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  ASSERT_TRUE(program.sendAtWork(SIGINT)) << "done before the signal";
  const Outcome stopped = program.finish();
  // Between two faces, or in the middle of one that takes long.
  EXPECT_THAT(stopped.exitStatus, ::testing::AnyOf(1, 128 + SIGINT));
  ASSERT_THAT(stopped.errLines(), SizeIs(1)) << stopped.err;
  EXPECT_THAT(stopped.err,
              HasSubstr(stopped.exitStatus == 1 ? "continues from there" : "files that are complete stay"));
  // Whatever is there is whole: nothing temporary, nothing half written.
  arguments = {"bake", demoScene("room"), "-o", out, "--set", "probes.room.faceSize=16", "--quiet"};
  EXPECT_EQ(runProgram(arguments).exitStatus, 0);
  const Json again = [&] {
    arguments.emplace_back("--json");
    return counters(runProgram(arguments));
  }();
  EXPECT_EQ(again["facesCaptured"], 0);
}

// What is left to do after an edit is what a fresh start would make otherwise.
TEST(Bake, CheckAfterAnEditSaysWhatAFreshBakeWouldChange) {
  const TemporaryFolder folder;
  Json scene = twoProbeRoom();
  scene["objects"]["sphere 1"]["seenByProbes"] = true;
  scene["materials"]["sphere"] = {{"transmission", 0.8}, {"thin", false}};
  scene["lights"] = {{{"type", "point"}, {"position", {0.4, 2.2, -0.9}}, {"intensity", 1.9}, {"range", 5.5}}};
  scene["probes"].erase(1);
  scene["probes"][0]["bounces"] = 1;
  scene["probes"][0]["faceSize"] = 16;
  scene["probes"][0]["samplesPerPixel"] = 1;
  const std::string path = folder.write("room.boxprobe.json", scene.dump());
  const auto bake = [&](const std::vector<std::string>& sets, const std::string& out, bool check) {
    std::vector<std::string> arguments = {"bake", path, "-o", folder.path(out), "--quiet"};
    if (check) arguments.emplace_back("--check");
    for (const std::string& set : sets) arguments.insert(arguments.end(), {"--set", set});
    return runProgram(arguments).exitStatus;
  };
  ASSERT_EQ(bake({}, "first", false), 0);
  const std::vector<std::string> inputs = {
      "lights.0.range=2.5",
      "materials.sphere.thickness=0.5",
      "materials.sphere.attenuationDistance=0.5",
      "probes.room.rotationDegrees=[0,20,0]",
      "probes.room.hides=[\"lamp\"]",
      "objects.lamp.translation=[0.3,0,0]",
      "energy=multiple",
  };
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    SCOPED_TRACE(inputs[i]);
    EXPECT_EQ(bake({inputs[i]}, "first", true), 3);
    const std::string out = "of" + std::to_string(i);
    ASSERT_EQ(bake({inputs[i]}, out, false), 0);
    // Nor does any other edit's bake pass for it.
    EXPECT_EQ(bake({inputs[(i + 1) % inputs.size()]}, out, true), 3);
  }
  const std::vector<std::string> others = {"exposure=2", "probes.room.intensity=0.5", "probes.room.technique=sphere",
                                           "probes.room.blendDistance=0.7", "probes.room.importance=3"};
  EXPECT_EQ(bake(others, "first", true), 0);
  ASSERT_EQ(bake(others, "others", false), 0);
  EXPECT_EQ(bake({}, "others", true), 0);
}

TEST(Bake, BadInputIsOneLine) {
  const TemporaryFolder folder;
  const auto line = [](const std::vector<std::string>& arguments, int status, const std::string& text,
                       DisplayKind display = DisplayKind::Inherited) {
    const Outcome outcome = runProgram(arguments, display);
    EXPECT_EQ(outcome.exitStatus, status) << outcome.err;
    EXPECT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(text));
  };
  folder.write("file", "");
  line({"bake", demoScene("room"), "-o", folder.path("file")}, 2, "names a folder");
  line({"bake", demoScene("room"), "-o", folder.path("file/in")}, 1, "cannot create");
  line({"bake", demoScene("room"), "-o", folder.path("x"), "--probe", "rom"}, 2, "--probe rom");
  line({"bake", demoScene("room"), "-o", folder.path("x"), "--offscreen", "x"}, 2, "DISPLAY", DisplayKind::Unset);
  const std::string picture = folder.write("none.exr", "no picture");
  Json scene = twoProbeRoom();
  scene["probes"][0]["mode"] = "custom";
  scene["probes"][0]["image"] = picture;
  const std::string path = folder.write("room.boxprobe.json", scene.dump());
  line({"render", path, "-o", folder.path("a.png"), "--quiet"}, 2, "probes.room.image: ");
  line({"bake", path, "--probe", "room"}, 2, "not baked");
}

}  // namespace
}  // namespace boxprobe::test
