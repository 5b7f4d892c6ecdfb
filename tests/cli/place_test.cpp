// `boxprobe place` finds the rooms of a model, is no worse than probes set by hand, writes a scene that holds what it
// placed, and refuses what it cannot do. Runs without a display throughout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "data/scenes/glb_writer.h"
#include "data/scenes/scenes.h"
#include "filters/io/scene/scene_file.h"
#include "tests/cli/program.h"
#include "tests/support/made_flat.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Without pictures, which have tests of their own.
Outcome place(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"place", "--unchecked"});
  return runProgram(arguments, DisplayKind::Unset);
}

json placed(std::vector<std::string> arguments) {
  arguments.push_back("--json");
  const Outcome outcome = place(std::move(arguments));
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(Place, FindsEveryApartmentAndIsNoWorseThanProbesSetByHand) {
  const TemporaryFolder folder;
  scenes::Apartments made = scenes::apartments(8, 1);
  made.scene.models = {{folder.write("apartments.glb", scenes::glbBytes(made.model))}};
  saveSceneFile(made.scene, folder.path("apartments.boxprobe.json"));
  const json report =
      placed({folder.path("apartments.boxprobe.json"), "-o", folder.path("placed.boxprobe.json"), "--quiet"});
  EXPECT_EQ(report["rooms"].size(), 10u) << "eight and two corridors";
  EXPECT_LE(report["probes"].size(), made.scene.probes.size());
  EXPECT_LE(report["after"]["meanDegrees"], 1.1 * report["before"]["meanDegrees"].get<double>());
  EXPECT_LT(report["after"]["unlit"], 0.01);
  for (const json& room : report["rooms"]) {
    EXPECT_LE(room["after"]["meanDegrees"], 1.1 * room["before"]["meanDegrees"].get<double>()) << room["name"];
    EXPECT_GE(room["doorways"].size(), 1u);
  }

  // Placed again among those, nothing is better by much; kept, they leave nothing to do.
  const json again = placed({folder.path("placed.boxprobe.json")});
  EXPECT_NEAR(again["before"]["meanDegrees"], report["after"]["meanDegrees"].get<double>(), 1e-6);
  const json kept = placed({folder.path("placed.boxprobe.json"), "--keep"});
  EXPECT_EQ(kept["probes"].size(), 0u);
  EXPECT_EQ(kept["kept"].size(), report["probes"].size());
}

// A share that was never run, a result that was damaged and the results of other wishes: the scene is that of one
// process, byte for byte.
TEST(Place, SharesMakeTheSceneOfOneProcess) {
  const TemporaryFolder folder;
  scenes::Apartments made = scenes::apartments(4, 1);
  made.scene.models = {{folder.write("apartments.glb", scenes::glbBytes(made.model))}};
  saveSceneFile(made.scene, folder.path("apartments.boxprobe.json"));
  const auto run = [&](const std::string& out, std::vector<std::string> more) {
    more.insert(more.begin(), {folder.path("apartments.boxprobe.json"), "-o", folder.path(out)});
    return place(std::move(more));
  };
  ASSERT_EQ(run("whole.boxprobe.json", {}).exitStatus, 0);
  const std::string out = "shared.boxprobe.json", parts = folder.path(out + ".parts");
  ASSERT_EQ(run(out, {"--shard", "1/3", "--fits-only", "--most", "1"}).exitStatus, 0);
  EXPECT_THAT(run(out, {"--shard", "1/3", "--fits-only"}).out, HasSubstr("share 1 of 3: 2 result(s) kept"));
  EXPECT_THAT(run(out, {"--shard", "1/3", "--fits-only"}).out, HasSubstr("share 1 of 3: 0 result(s) kept"));
  EXPECT_THAT(run(out, {"--shard", "2/3", "--fits-only"}).out, HasSubstr("share 2 of 3: 2 result(s) kept"));
  std::size_t damaged = 0;
  for (const auto& entry : std::filesystem::directory_iterator(parts)) {
    std::string bytes = readFile(entry.path());
    const std::size_t at = bytes.find("\"box\":[[");
    if (damaged++ == 0 && at != std::string::npos) std::ofstream(entry.path()) << bytes.replace(at + 8, 1, "9");
  }
  EXPECT_EQ(damaged, 5u) << "four, and one of other wishes";
  EXPECT_FALSE(std::filesystem::exists(folder.path(out)));
  const Outcome merged = run(out, {"--merge"});
  ASSERT_EQ(merged.exitStatus, 0) << merged.err;
  EXPECT_EQ(readFile(folder.path(out)), readFile(folder.path("whole.boxprobe.json")));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(parts), {}), 1) << "of other wishes";

  const Outcome nowhere = place({folder.path("apartments.boxprobe.json"), "--shard", "1/2"});
  EXPECT_EQ(nowhere.exitStatus, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("add -o FILE"));
  const Outcome script = run(out, {"--emit", "slurm", "--shards", "3", "--most", "7"});
  EXPECT_THAT(script.out, HasSubstr("--array=1-3 "));
  EXPECT_THAT(script.out, HasSubstr("--most 7 --unchecked --quiet --fits-only --shard auto"));
  EXPECT_THAT(script.out, HasSubstr("--most 7 --unchecked --merge"));
}

TEST(Place, TakesABareFlatInCentimetresOnALargePlain) {
  const TemporaryFolder folder;
  FlatWishes wishes;
  wishes.unitsPerMetre = 100.0;
  wishes.yawDegrees = 25.0;
  wishes.groundMetres = 80.0;
  const std::string model = folder.write("flat.glb", scenes::glbBytes(madeFlat(wishes)));
  const std::string output = folder.path("flat.boxprobe.json");
  const Outcome outcome = place({model, "--set", "models.0.unit=cm", "-o", output});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 rooms, 2 probes placed"));
  EXPECT_THAT(outcome.out, HasSubstr("open to room 2"));
  const Scene scene = loadSceneFile(output);
  ASSERT_EQ(scene.probes.size(), 2u);
  EXPECT_NEAR(std::remainder(scene.probes[0].rotationDegrees.y - 25.0, 90.0), 0.0, 0.5);
  EXPECT_NEAR(scene.probes[0].box.size().y, 2.6, 0.03) << "in metres";
  const json one = placed({output, "--most", "1"});
  EXPECT_EQ(one["probes"].size(), 1u);
  EXPECT_THAT(one["rooms"][1]["decisions"][0], HasSubstr("no more than 1"));
}

TEST(Place, LeavesAnOpenSceneAsItIs) {
  const TemporaryFolder folder;
  folder.write("model.gltf", triangleGltf());
  const std::string scene = folder.write("open.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1,
    "model": "model.gltf", "probes": [{"name": "p", "origin": [0, 1, 1], "box": {"min": [-1, 0, -1], "max": [1, 2, 2]}}]})");
  const std::string output = folder.path("placed.boxprobe.json");
  const Outcome outcome = place({scene, "-o", output});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("open: no room was found"));
  EXPECT_THAT(outcome.out, HasSubstr("the scene's probes stay"));
  ASSERT_EQ(loadSceneFile(output).probes.size(), 1u) << "nothing is lost";
}

TEST(Place, AnInvertedRoomIsARoomIfItsUserSaysSo) {
  const TemporaryFolder folder;
  FlatWishes wishes;
  wishes.inverted = true;
  const std::string model = folder.write("flat.glb", scenes::glbBytes(madeFlat(wishes)));
  const Outcome plain = place({model});
  EXPECT_EQ(plain.exitStatus, 0) << plain.err;
  EXPECT_THAT(plain.out, HasSubstr("its faces are inverted: turn them over, or use --as interior"));
  EXPECT_EQ(placed({model, "--as", "interior"})["probes"].size(), 2u);
}

json checked(const std::string& scene, const std::string& output) {
  const Outcome outcome = runProgram({"place", scene, "-o", output, "--json", "--quiet"}, DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(PlaceChecked, PicturesAreBetterThanWithWhatTheSceneHad) {
  const TemporaryFolder folder;
  scenes::Apartments made = scenes::apartments(2, 1);
  made.scene.models = {{folder.write("apartments.glb", scenes::glbBytes(made.model))}};
  saveSceneFile(made.scene, folder.path("apartments.boxprobe.json"));
  const std::string output = folder.path("placed.boxprobe.json");
  const json report = checked(folder.path("apartments.boxprobe.json"), output);
  const json& pictures = report["pictures"];
  EXPECT_GE(pictures["eyes"], 4) << "two rooms and a corridor";
  EXPECT_TRUE(pictures["better"]);
  EXPECT_LT(pictures["after"]["error"], 0.9 * pictures["before"]["error"].get<double>());
  EXPECT_FALSE(pictures["tried"].empty());
  EXPECT_EQ(loadSceneFile(output).probes.size(), report["probes"].size() + report["kept"].size());
  for (const json& probe : report["probes"]) EXPECT_FALSE(probe["reason"].get<std::string>().empty());
}

TEST(PlaceChecked, SaysThatThereIsNoLightToCompareIn) {
  const TemporaryFolder folder;
  folder.write("flat.glb", scenes::glbBytes(madeFlat()));
  const std::string scene = folder.write("dark.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1,
    "model": "flat.glb", "sky": {"color": [0, 0, 0]}, "probes": [{"name": "mine", "origin": [2, 1.2, 0.3],
    "box": {"min": [0, 0, -1.5], "max": [5.1, 2.6, 1.5]}}]})");
  const json report = checked(scene, folder.path("placed.boxprobe.json"));
  ASSERT_FALSE(report["pictures"]["tried"].empty());
  EXPECT_THAT(report["pictures"]["tried"][0], HasSubstr("the scene has no light"));
  EXPECT_EQ(report["probes"].size(), 2u) << "placed by angles alone";
}

// A ceiling that ends 0.2 mm before a wall: single rays of the path tracer find the sky.
TEST(PlaceChecked, ComparesNothingByTheLightOfACrack) {
  const TemporaryFolder folder;
  folder.write("cracked.obj", R"(v -2.1 0 -1.4
v 1.9 0 -1.4
v 1.9 0 1.7
v -2.1 0 1.7
v -2.1 2.6 -1.4
v 1.9 2.6 -1.4
v 1.9 2.6 1.7
v -2.1 2.6 1.7
v 1.8998 2.6 -1.4
v 1.8998 2.6 1.7
f 1 4 3 2
f 5 9 10 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)");
  const std::string scene = folder.write("cracked.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1,
    "model": "cracked.obj", "sky": {"color": [0.9, 1.1, 1.3]}})");
  const json report = checked(scene, folder.path("placed.boxprobe.json"));
  ASSERT_FALSE(report["pictures"]["tried"].empty());
  EXPECT_THAT(report["pictures"]["tried"][0], HasSubstr("too little to tell it from noise"));
  EXPECT_EQ(report["probes"].size(), 1u) << "placed by angles alone";
}

TEST(Place, RefusesWhatItCannotDo) {
  const auto refused = [](const std::vector<std::string>& arguments, const char* text) {
    const Outcome outcome = place(arguments);
    EXPECT_EQ(outcome.exitStatus, 2);
    EXPECT_EQ(outcome.errLines().size(), 1u);
    EXPECT_THAT(outcome.err, HasSubstr(text));
  };
  refused({demoScene("room"), "--most", "0"}, "--most");
  refused({demoScene("room"), "--gain", "-1"}, "--gain");
  refused({demoScene("room"), "-o", "/nowhere/out.boxprobe.json"}, "/nowhere");
  refused({demoScene("room"), "-o", "placed.txt"}, "placed.txt");
  refused({"no-such.glb"}, "no such file");
}

}  // namespace
}  // namespace boxprobe::test
