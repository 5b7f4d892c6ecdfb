// `boxprobe info` tells what the files hold. Runs without a display throughout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

json infoJson(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"info", "--json"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Outcome outcome = runProgram(all, DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(Info, ABareObjectHasAStudioACameraAndNoProbe) {
  const TemporaryFolder folder;
  const json report = infoJson({folder.write("model.gltf", triangleGltf())});
  ASSERT_EQ(report["models"].size(), 1u);
  EXPECT_EQ(report["models"][0]["meshes"], 1);
  EXPECT_EQ(report["models"][0]["triangles"], 1);
  EXPECT_EQ(report["models"][0]["materials"], json({"paint"}));
  EXPECT_EQ(report["models"][0]["unit"], "m");
  EXPECT_EQ(report["fit"]["kind"], "object");
  EXPECT_EQ(report["fit"]["light"], "studio");
  EXPECT_EQ(report["fit"]["exposure"], "fixed");
  EXPECT_EQ(report["exposure"], 1.0);
  EXPECT_EQ(report["probes"].size(), 0u);
  EXPECT_EQ(report["sky"]["kind"], "image");
  ASSERT_EQ(report["cameras"].size(), 1u);
  EXPECT_GT(report["cameras"][0]["position"][2], 0.7);  // outside the bounds: (0, 0, 0) to (1, 1, 0)
}

TEST(Info, ABareInteriorIsSaidWithItsReasonAndCanBeTreatedOtherwise) {
  const std::string room = fs::path(demoScene("room")).replace_filename("room.glb").string();
  const json report = infoJson({room});
  EXPECT_EQ(report["fit"]["kind"], "interior");
  EXPECT_EQ(report["fit"]["exposure"], "automatic");
  ASSERT_EQ(report["probes"].size(), 1u);
  EXPECT_NEAR(report["probes"][0]["box"]["max"][0].get<double>(), 4.0, 0.05);
  const Outcome text = runProgram({"info", room}, DisplayKind::Unset);
  EXPECT_THAT(text.out, HasSubstr("treated as an interior ("));
  EXPECT_THAT(text.out, HasSubstr("exposure automatic: known once a frame is drawn"));
  const json object = infoJson({room, "--as", "object", "--light", "daylight"});
  EXPECT_EQ(object["fit"]["kind"], "object");
  EXPECT_EQ(object["fit"]["found"], "interior");
  EXPECT_EQ(object["fit"]["light"], "daylight");
  EXPECT_EQ(object["probes"].size(), 0u);
  EXPECT_EQ(runProgram({"info", room, "--as", "cave"}, DisplayKind::Unset).exitStatus, 2);
}

TEST(Info, FieldsListsEveryKeyWithoutAScene) {
  const Outcome text = runProgram({"info", "--fields"}, DisplayKind::Unset);
  EXPECT_EQ(text.exitStatus, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("| `filterSamples` | whole number from 8 to 768 | `64` | capture | "));
  const json parts = infoJson({"--fields"});
  const auto probes =
      std::find_if(parts.begin(), parts.end(), [](const json& part) { return part["path"] == "probes[]"; });
  ASSERT_NE(probes, parts.end());
  const json& fields = (*probes)["fields"];
  const auto samples =
      std::find_if(fields.begin(), fields.end(), [](const json& field) { return field["key"] == "filterSamples"; });
  ASSERT_NE(samples, fields.end());
  EXPECT_EQ((*samples)["lowest"], 8);
  EXPECT_EQ((*samples)["highest"], 768);
  EXPECT_EQ((*samples)["default"], 64);
  EXPECT_EQ((*samples)["changes"], json({"capture"}));

  EXPECT_THAT(runProgram({"info"}, DisplayKind::Unset).err, HasSubstr("SCENE is required; see boxprobe info --help"));
  EXPECT_EQ(runProgram({"info", "room.json", "--fields"}, DisplayKind::Unset).exitStatus, 2);
}

TEST(Info, ListsOverridesAndWhatTheyMiss) {
  const TemporaryFolder folder;
  folder.write("model.gltf", triangleGltf());
  const std::string path = folder.write("scene.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1,
      "model": "model.gltf", "sky": {"color": [1, 2, 3]},
      "lights": [{"type": "point", "position": [0, 2, 0], "intensity": 5}],
      "objects": {"triangle": {"seenByProbes": false}, "ghost": {"visible": false}},
      "materials": {"gold": {"roughness": 0.5}},
      "probes": [{"name": "room", "hides": ["phantom"], "faceSize": 64}]})");
  const json report = infoJson({path});
  ASSERT_EQ(report["objects"].size(), 1u);
  EXPECT_EQ(report["objects"][0]["name"], "triangle");
  EXPECT_EQ(report["objects"][0]["seenByProbes"], false);
  EXPECT_EQ(report["sky"], json({{"kind", "color"}, {"color", {1, 2, 3}}}));
  EXPECT_EQ(report["lights"][0]["intensity"], 5);
  std::string warnings = report["warnings"].dump();
  for (const char* name : {"objects.ghost", "materials.gold", "phantom"}) EXPECT_THAT(warnings, HasSubstr(name));

  const Outcome text = runProgram({"info", path}, DisplayKind::Unset);
  EXPECT_EQ(text.exitStatus, 0);
  for (const char* part : {"triangle, not seen by probes", "room", "objects.ghost", "point"}) {
    EXPECT_THAT(text.out, HasSubstr(part));
  }
}

TEST(Info, TellsLampsAndWhereDiffuseLightComesFrom) {
  const json gallery = infoJson({demoScene("gallery")});
  ASSERT_FALSE(gallery["lamps"].empty());
  EXPECT_EQ(gallery["lamps"][0]["object"], "window");
  EXPECT_EQ(gallery["lamps"][0]["polygons"], 1);
  EXPECT_NEAR(gallery["lamps"][0]["area"].get<double>(), 0.96, 0.01);
  EXPECT_EQ(gallery["probes"][0]["diffuseLight"], "lamps and lattice");
  const json inMap = infoJson({demoScene("gallery"), "--set", "lamps=in-map"});
  EXPECT_TRUE(inMap["lamps"].empty());
  EXPECT_EQ(inMap["probes"][0]["diffuseLight"], "coefficients");
  const json none = infoJson({demoScene("gallery"), "--set", "probes.gallery.lattice=false"});
  EXPECT_EQ(none["probes"][0]["diffuseLight"], "coefficients");
  const Outcome text = runProgram({"info", demoScene("building")}, DisplayKind::Unset);
  EXPECT_THAT(text.out, HasSubstr("objects.far hills: a curved lamp"));
}

TEST(Info, SetIsAppliedFirst) {
  const json report = infoJson({demoScene("room"), "--set", "exposure=2", "--set", "sky.color=[4,5,6]"});
  EXPECT_EQ(report["sky"], json({{"kind", "color"}, {"color", {4, 5, 6}}}));
}

TEST(Info, DemoScenesHaveNothingToSkip) {
  for (const char* name : {"building", "room"}) {
    SCOPED_TRACE(name);
    const json report = infoJson({demoScene(name)});
    EXPECT_GT(report["models"][0]["triangles"], 10);
    EXPECT_GE(report["probes"].size(), 1u);
    EXPECT_GE(report["cameras"].size(), 1u);
    EXPECT_EQ(report["warnings"], json::array());
  }
}

TEST(Info, AFrameTellsWhatItDrawsWithWhichProbes) {
  const std::string scene = std::string(BOXPROBE_DATA_DIR) + "/scenes/room.boxprobe.json";
  const Outcome outcome =
      runProgram({"info", "--json", "--frame", "--size", "64x48", "--set", "probes.room.faceSize=64", scene});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  const json frame = json::parse(outcome.out)["frame"];
  EXPECT_GE(frame["drawsByProbeCount"][1], 1);
  EXPECT_EQ(frame["lookupsPerPixelMax"], 1.0);
  EXPECT_GT(frame["lookupsPerPixelMean"], 0.0);
  ASSERT_EQ(frame["probes"].size(), 1u);
  const std::size_t bytes = frame["probes"][0]["memoryBytes"];
  EXPECT_GT(bytes, 0u);
  const Outcome text = runProgram({"info", "--frame", "--size", "64x48", "--set", "probes.room.faceSize=64", scene});
  char expected[64], decimal[64];
  std::snprintf(expected, sizeof expected, "\n  room: %.2f MiB, ", static_cast<double>(bytes) / (1024.0 * 1024.0));
  std::snprintf(decimal, sizeof decimal, "\n  room: %.2f MiB, ", static_cast<double>(bytes) / 1.0e6);
  ASSERT_STRNE(expected, decimal) << "too few bytes to tell MiB from MB";
  EXPECT_NE(text.out.find(expected), std::string::npos) << expected << text.out;
  for (const json& object : frame["objects"]) {
    if (object["name"] == "floor") {
      EXPECT_EQ(object["probes"]["room"], 1.0);
    }
  }
}

// No time is judged: that the parts are there, are of that frame, and add up to it.
TEST(Info, TheCostsOfAFrameAddUpToIt) {
  const std::string scene = std::string(BOXPROBE_DATA_DIR) + "/scenes/room.boxprobe.json";
  const Outcome outcome = runProgram(
      {"info", "--json", "--frame", "--costs", "--size", "64x48", "--set", "probes.room.faceSize=16", scene});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  const json costs = json::parse(outcome.out)["frame"]["costs"];
  EXPECT_GT(costs["frame"]["milliseconds"], 0.0);
  EXPECT_EQ(costs["frame"]["share"], 1.0);
  std::vector<std::string> parts;
  for (const json& part : costs["parts"]) {
    parts.push_back(part["part"]);
    EXPECT_LE(part["low"], part["milliseconds"]) << part;
    EXPECT_LE(part["milliseconds"], part["high"]) << part;
  }
  EXPECT_EQ(parts,
            (std::vector<std::string>{"reflection", "light loop", "material", "output", "other shading", "pixels",
                                      "vertices", "sky", "ambient occlusion", "ground shadow", "window"}));
  std::size_t objects = 0;
  for (const json& program : costs["programs"]) objects += program["objects"].size();
  EXPECT_EQ(objects, costs["objects"].size());
  EXPECT_GT(objects, 3u);
}

TEST(Info, CostsAreOfAFrame) {
  const std::string scene = std::string(BOXPROBE_DATA_DIR) + "/scenes/room.boxprobe.json";
  const Outcome outcome = runProgram({"info", "--costs", scene}, DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--frame"));
}

}  // namespace
}  // namespace boxprobe::test
