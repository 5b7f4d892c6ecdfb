// `boxprobe fit` finds the walls of rooms, says what it gained, writes a scene that holds it, and refuses what it
// cannot do. Runs without a display throughout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

Outcome fit(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "fit");
  return runProgram(arguments, DisplayKind::Unset);
}

json fitted(std::vector<std::string> arguments) {
  arguments.push_back("--json");
  const Outcome outcome = fit(std::move(arguments));
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  return json::parse(outcome.out);
}

void expectRoom(const json& box) {
  const double low[] = {-4.0, 0.0, -3.0}, high[] = {4.0, 3.0, 3.0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double allowed = 0.01 * (high[axis] - low[axis]);
    EXPECT_NEAR(box["min"][axis].get<double>(), low[axis], allowed) << axis;
    EXPECT_NEAR(box["max"][axis].get<double>(), high[axis], allowed) << axis;
  }
}

TEST(Fit, FindsTheWallsOfTheRoomFromBoxesOffByHalf) {
  const char* boxes[][2] = {{"[-8,-1.5,-6]", "[8,4.5,6]"}, {"[-2,0.5,-1]", "[2,2,1]"}, {"[-6,-1,-2]", "[2,4.5,4]"}};
  for (const auto& box : boxes) {
    const json report = fitted({demoScene("room"), "--set", std::string("probes.room.box.min=") + box[0], "--set",
                                std::string("probes.room.box.max=") + box[1]});
    ASSERT_EQ(report["probes"].size(), 1u);
    const json& probe = report["probes"][0];
    EXPECT_EQ(report["kind"], "interior");
    EXPECT_EQ(probe["name"], "room");
    EXPECT_EQ(probe["rotationDegrees"], json({0.0, 0.0, 0.0}));
    EXPECT_EQ(probe["origin"], json({0.7, 1.4, -0.5}));
    expectRoom(probe["box"]);
    EXPECT_GT(probe["before"]["meanDegrees"], 1.0);
    EXPECT_LT(probe["after"]["meanDegrees"], 0.05);
    EXPECT_LT(probe["after"]["p95Degrees"], 0.2);
    EXPECT_GT(probe["faces"]["+z"]["gainDegrees"], 0.0);
    EXPECT_GT(probe["faces"]["-z"]["sensitivity"], 1.0);
    EXPECT_GT(probe["seconds"], 0.0);
  }
}

TEST(Fit, LowersTheErrorOfBoxesSetByHand) {
  for (const char* scene : {"building", "furnished"}) {
    const json report = fitted({demoScene(scene)});
    EXPECT_LT(report["probes"][0]["after"]["meanDegrees"], report["probes"][0]["before"]["meanDegrees"]) << scene;
  }
}

/// A box room of lamps: each wall is one, of its own brightness. The probe's box is 3 m too short at +x.
std::string roomOfLamps(const TemporaryFolder& folder, const std::vector<double>& brightness) {
  const double x[] = {-3.0, 4.0}, y[] = {0.0, 2.5}, z[] = {-2.0, 5.0};
  std::string obj = "mtllib walls.mtl\n", mtl;
  for (int corner = 0; corner < 8; ++corner) {
    obj += "v " + std::to_string(x[corner & 1]) + " " + std::to_string(y[corner >> 1 & 1]) + " " +
           std::to_string(z[corner >> 2]) + "\n";
  }
  // Corners anticlockwise as seen from within: -x, +x, -y, +y, -z, +z.
  const int walls[6][4] = {{1, 3, 7, 5}, {2, 6, 8, 4}, {1, 5, 6, 2}, {3, 4, 8, 7}, {1, 2, 4, 3}, {5, 7, 8, 6}};
  for (std::size_t wall = 0; wall < 6; ++wall) {
    const std::string name = "wall" + std::to_string(wall), light = std::to_string(brightness[wall]);
    mtl += "newmtl " + name + "\nKd 0 0 0\nKe " + light + " " + light + " " + light + "\nPr 1\nPm 0\n";
    obj += "usemtl " + name + "\nf";
    for (const int corner : walls[wall]) obj += " " + std::to_string(corner);
    obj += "\n";
  }
  folder.write("walls.mtl", mtl);
  folder.write("walls.obj", obj);
  const json scene = {
      {"format", "boxprobe-scene"},
      {"version", 1},
      {"model", "walls.obj"},
      {"probes",
       {{{"name", "p"}, {"origin", {0.4, 1.3, 0.9}}, {"box", {{"min", {-3.0, 0.0, -2.0}}, {"max", {1.0, 2.5, 5.0}}}}}}},
      {"cameras", {{"c", {{"position", {-2.0, 1.6, -1.0}}, {"target", {3.0, 0.4, 3.0}}}}}}};
  return folder.write("walls.boxprobe.json", scene.dump());
}

TEST(Fit, SaysWhatEachFaceGainsOfTheLight) {
  const TemporaryFolder folder;
  // The wall that is missed is the bright one: angle and light are gained, by that face.
  const json bright = fitted({roomOfLamps(folder, {0.4, 5.0, 0.7, 0.55, 0.3, 0.85})})["probes"][0];
  ASSERT_EQ(bright["outcome"], "fitted");
  EXPECT_GT(bright["before"]["lightError"], 0.1);
  EXPECT_LT(bright["after"]["lightError"], 0.02) << "the box is the room";
  EXPECT_NEAR(bright["faces"]["+x"]["gainLight"].get<double>(),
              bright["before"]["lightError"].get<double>() - bright["after"]["lightError"].get<double>(), 0.02);
  for (const char* face : {"-x", "-y", "+y", "-z", "+z"}) {
    EXPECT_NEAR(bright["faces"][face]["gainLight"].get<double>(), 0.0, 0.01) << face;
  }
  // All walls alike, and rough: however wrong the lookup, what it finds is right, but for the little that they mirror.
  const json even = fitted({roomOfLamps(folder, {0.6, 0.6, 0.6, 0.6, 0.6, 0.6})})["probes"][0];
  EXPECT_GT(even["before"]["meanDegrees"], 1.0);
  EXPECT_NEAR(even["before"]["lightError"].get<double>(), 0.0, 0.02);
  EXPECT_NEAR(even["faces"]["+x"]["gainLight"].get<double>(), 0.0, 0.02);
  // Without light there is nothing to say.
  const std::string dark = roomOfLamps(folder, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_FALSE(fitted({dark})["probes"][0]["before"].contains("lightError"));
  EXPECT_THAT(fit({dark}).out, ::testing::Not(HasSubstr("light")));
}

TEST(Fit, WritesASceneWithTheFitAndNothingUnasked) {
  const TemporaryFolder folder;
  const std::string scene = demoScene("room"), wrong = "probes.room.box.max=[2,4.5,4]";
  const std::string before = readFile(scene);
  const Outcome plain = fit({scene, "--set", wrong});
  EXPECT_EQ(plain.exitStatus, 0) << plain.err;
  EXPECT_THAT(plain.out, HasSubstr("room: a better box was found"));
  EXPECT_THAT(plain.out, HasSubstr("+x     2.000 ->    4.0"));
  EXPECT_EQ(readFile(scene), before);
  const std::string output = folder.path("fitted.boxprobe.json");
  EXPECT_EQ(fit({scene, "--set", wrong, "-o", output, "--quiet"}).out, "");
  EXPECT_EQ(folder.names().size(), 1u);
  const json again = fitted({output});
  EXPECT_EQ(again["probes"][0]["outcome"], "kept");
  expectRoom(again["probes"][0]["box"]);
}

TEST(Fit, MovesTheFacesAskedForAlone) {
  const json report = fitted({demoScene("room"), "--faces", "+x,-z", "--set", "probes.room.box.max=[2,4.5,4]", "--set",
                              "probes.room.box.min=[-4,0,-2]"});
  const json& box = report["probes"][0]["box"];
  EXPECT_EQ(box["max"][1], 4.5);
  EXPECT_EQ(box["max"][2], 4.0);
  EXPECT_EQ(box["min"][0], -4.0);
  EXPECT_NEAR(box["max"][0].get<double>(), 4.0, 0.4);
  EXPECT_NEAR(box["min"][2].get<double>(), -3.0, 0.3);
}

TEST(Fit, TakesABareModel) {
  namespace fs = std::filesystem;
  const json room = fitted({fs::path(demoScene("room")).replace_filename("room.glb").string()});
  EXPECT_EQ(room["kind"], "interior");
  ASSERT_EQ(room["probes"].size(), 1u);
  expectRoom(room["probes"][0]["box"]);
  const TemporaryFolder folder;
  const std::string triangle = folder.write("model.gltf", triangleGltf());
  const json thing = fitted({triangle});
  EXPECT_EQ(thing["kind"], "object");
  EXPECT_EQ(thing["probes"].size(), 0u);
  EXPECT_THAT(fit({triangle}).out, HasSubstr("nothing to fit"));
}

TEST(Fit, ProposesAnOriginThatSeesMore) {
  const json report = fitted({demoScene("building"), "--origin", "propose"});
  const json& probe = report["probes"][0];
  EXPECT_NE(probe["origin"], json({0.0, 1.6, 0.0}));
  EXPECT_LT(probe["hidden"], probe["hiddenBefore"]);
}

TEST(Fit, LeavesTheBoxWhereTheOriginIsInAWallOrThereAreNoWalls) {
  const json inside = fitted({demoScene("building"), "--set", "probes.room.origin=[4.75,2,0]"});  // a pillar
  EXPECT_EQ(inside["probes"][0]["outcome"], "inside");
  EXPECT_EQ(inside["probes"][0]["box"]["min"][0], -4.505);
  const TemporaryFolder folder;
  const std::string scene = folder.path("open.boxprobe.json");
  const std::string model = folder.write("model.gltf", triangleGltf());
  folder.write("open.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1, "model": "model.gltf",
    "probes": [{"name": "p", "origin": [0, 1, 1], "box": {"min": [-1, 0, -1], "max": [1, 2, 2]}}]})");
  const Outcome open = fit({scene});
  EXPECT_EQ(open.exitStatus, 0) << open.err;
  EXPECT_THAT(open.out, HasSubstr("p: open: nothing to fit to; the box stays"));
}

TEST(Fit, RefusesWhatItCannotDo) {
  const auto refused = [](const std::vector<std::string>& arguments, const char* text) {
    const Outcome outcome = fit(arguments);
    EXPECT_EQ(outcome.exitStatus, 2);
    EXPECT_EQ(outcome.errLines().size(), 1u);
    EXPECT_THAT(outcome.err, HasSubstr(text));
  };
  refused({demoScene("room"), "--probe", "hall"}, "--probe hall: no probe of that name; the scene has: room");
  refused({demoScene("room"), "--faces", "+x,up"}, "--faces +x,up: no face up; there are: -x, +x");
  refused({demoScene("room"), "--yaw", "turn"}, "--yaw");
  refused({demoScene("room"), "-o", "/nowhere/out.boxprobe.json"}, "/nowhere");
  refused({demoScene("room"), "-o", "fitted.txt"}, "fitted.txt");
  refused({"no-such.boxprobe.json"}, "no such file");
}

}  // namespace
}  // namespace boxprobe::test
