// `bench` on a small plan: whole files whose ratios and front follow from their rows, what it refuses, and what Ctrl-C
// leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "filters/core/picture/pareto_front.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/pareto_front_file.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

nlohmann::json parsed(const std::string& path) {
  return nlohmann::json::parse(readFile(path));
}

std::string rowKey(const nlohmann::json& row) {
  std::ostringstream key;
  key << row["camera"] << row["roughness"] << row["surface"] << row["reference"];
  return key.str();
}

TEST(Bench, WholePicturesAreJudgedByAllLight) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = {"bench",        demoScene("room"),  "--whole", "--quick",
                                        "--techniques", "infinite",         "--size",  "64x36",
                                        "-o",           folder.path("out"), "--json"};
  Outcome outcome = runProgram(arguments, DisplayKind::Unset);
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json, parsed(folder.path("out/whole.json")));
  EXPECT_EQ(json["complete"], true);
  ASSERT_THAT(json["rows"], SizeIs(4));  // the two baselines with them
  const auto partOf = [&json](std::size_t row, const std::string& name) {
    for (const auto& part : json["rows"][row]["parts"]) {
      if (part["part"] == name) return part;
    }
    return nlohmann::json();
  };
  EXPECT_EQ(json["rows"][0]["technique"], "as it is");
  EXPECT_EQ(json["rows"][0]["bounces"], "all");
  EXPECT_EQ(partOf(0, "all")["pixels"], 64 * 36);
  // Without parallax correction the floor reflects the wrong places.
  EXPECT_GT(partOf(1, "glossy")["relativeRmse"], 1.2 * partOf(0, "glossy")["relativeRmse"].get<double>());
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--rooms", "3"}, {"--roughness", "0.5"}, {"--materials", "floor"}}) {
    std::vector<std::string> refused = arguments;
    refused.insert(refused.end(), more.begin(), more.end());
    outcome = runProgram(refused, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2);
    EXPECT_THAT(outcome.err, HasSubstr(more[0] + " is not for --whole"));
  }
}

TEST(Bench, FilesOfASmallRunAgreeWithEachOther) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"bench", demoScene("gallery"), "-o", folder.path("out"), "--quick",
                                      "--techniques", "infinite,footprint1,footprint8", "--roughness", "0.25,0.75",
                                      "--camera", "main,low", "--size", "96x54", "--quiet", "--set", "lamps=in-map"},
                                     DisplayKind::Unset);  // charts, too, are drawn without one
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, "");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("out")))
    names.insert(entry.path().filename());
  EXPECT_THAT(names,
              ElementsAre("bench.csv", "bench.json", "contact.png", "front-scene.png", "front.png", "report.md"));

  const nlohmann::json json = parsed(folder.path("out/bench.json"));
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["scene"], "gallery.boxprobe.json");
  // Techniques, the two baselines with them, times cameras, roughnesses, kinds of surface and references.
  const std::set<std::string> ids = {"infinite+none", "box+footprint1", "box+footprint8", "box+hdrp", "box+none"};
  std::map<std::string, std::map<std::string, double>> errors;
  double smallest = 1e9;
  for (const auto& row : json["rows"]) {
    EXPECT_EQ(ids.count(row["technique"]), 1u) << row["technique"];
    errors[rowKey(row)][row["technique"]] = row["error"];
    EXPECT_GT(row["pixels"], 0);
    EXPECT_GT(row["frameCpuRatioToBox"], 0.0);
    smallest = std::min(smallest, row["error"].get<double>());
  }
  EXPECT_EQ(errors.size(), 16u);
  EXPECT_EQ(json["rows"].size(), 16u * ids.size());
  std::map<std::pair<std::string, std::string>, std::pair<double, double>> pooled;
  for (const auto& row : json["rows"]) {
    const double own = row["error"], hdrp = errors[rowKey(row)]["box+hdrp"];
    EXPECT_NEAR(row["errorRatioToHdrp"].get<double>(), own / hdrp, 2e-3) << row;
    auto& [squares, pixels] = pooled[{row["reference"], row["technique"]}];
    squares += own * own * row["pixels"].get<double>();
    pixels += row["pixels"].get<double>();
  }
  std::vector<ParetoPoint> points;
  for (const auto& summary : json["summary"]) {
    const auto& [squares, pixels] = pooled[{summary["reference"], summary["technique"]}];
    EXPECT_NEAR(summary["error"].get<double>(), std::sqrt(squares / pixels), 2e-5) << summary;
    if (summary["reference"] == "box") {
      points.push_back({summary["technique"], "", summary["frameCpuRatioToBox"], summary["error"]});
      EXPECT_EQ(summary["ours"].get<bool>(),
                summary["technique"].get<std::string>().find("footprint") != std::string::npos);
    }
  }
  // In random rooms as in the scene.
  std::map<std::string, double> inRooms;
  for (const auto& row : json["study"]["rows"]) {
    inRooms[row["technique"]] = row["error"];
    EXPECT_THAT(row["brightnessRatios"], SizeIs(18));
  }
  ASSERT_EQ(inRooms.size(), ids.size());
  EXPECT_LT(inRooms["box+footprint8"], 0.6 * inRooms["box+hdrp"]);
  EXPECT_GT(inRooms["infinite+none"], 1.5 * inRooms["box+hdrp"]);
  for (const auto& summary : json["summary"]) {
    EXPECT_TRUE(summary["ownCpuRatioToBox"].is_number()) << summary;
  }
  // The front is what it says, and what a window reads from the file.
  markParetoFront(points);
  const std::vector<ParetoPoint> loaded = loadParetoFront(folder.path("out/bench.json"));
  ASSERT_EQ(loaded.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(loaded[i].id, points[i].id);
    EXPECT_EQ(loaded[i].onParetoFront, points[i].onParetoFront) << points[i].id;
  }
  // The references know their colours far better than any technique, and agree in a room that is the box.
  for (const auto& reference : json["references"]) {
    const double share = reference["reference"] == "box" ? 0.25 : 0.4;
    EXPECT_LT(reference["standardError"].get<double>(), share * smallest) << reference;
  }
  for (const auto& [key, byTechnique] : errors)
    EXPECT_LT(byTechnique.at("box+footprint8"), byTechnique.at("infinite+none"));

  const std::string csv = readFile(folder.path("out/bench.csv"));
  std::istringstream lines(csv);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 15) << line;
  EXPECT_EQ(count, json["rows"].size() + 1);
  const ImageRgba8 chart = loadImage8(folder.path("out/front.png"));
  EXPECT_EQ(chart.width, 1400);
  const ImageRgba8 sheet = loadImage8(folder.path("out/contact.png"));
  EXPECT_GT(sheet.width, 5 * 96);
  EXPECT_THAT(readFile(folder.path("out/report.md")), HasSubstr("footprint8"));
}

/// Error of plain box projection against the ray-traced scene by roughness, of what shows `material` alone through
/// camera main. Empty if the run fails.
std::map<double, double> errorsOf(const std::string& scene, const std::string& folder, const std::string& material,
                                  const std::string& roughness) {
  const Outcome outcome =
      runProgram({"bench", scene, "-o", folder, "--quick", "--techniques", "box", "--roughness", roughness, "--camera",
                  "main", "--materials", material, "--rooms", "0", "--quiet"},
                 DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  std::map<double, double> errors;
  if (outcome.exitStatus != 0) return errors;
  const auto report = parsed(folder + "/bench.json");
  for (const auto& row : report["rows"]) {
    if (row["technique"] == "box+none" && row["reference"] == "scene") errors[row["roughness"]] = row["error"];
  }
  return errors;
}

TEST(Bench, AProposedOriginBettersTheFloorMirrorAlone) {
  const TemporaryFolder folder;
  const Outcome fitted = runProgram(
      {"fit", demoScene("building"), "--origin", "propose", "-o", folder.path("fitted.boxprobe.json"), "--quiet"});
  ASSERT_EQ(fitted.exitStatus, 0) << fitted.err;
  const auto byHand = errorsOf(demoScene("building"), folder.path("hand"), "mirror", "0,0.1");
  const auto proposed = errorsOf(folder.path("fitted.boxprobe.json"), folder.path("proposed"), "mirror", "0,0.1");
  ASSERT_EQ(byHand.size(), 2u);
  ASSERT_EQ(proposed.size(), 2u);
  for (const auto& [roughness, error] : byHand) {
    ASSERT_EQ(proposed.count(roughness), 1u) << "roughness " << roughness;
    std::printf(
        "floor mirror of building at roughness %g: %.4f with the origin set by hand, %.4f with the proposed one\n",
        roughness, error, proposed.at(roughness));
    EXPECT_LT(proposed.at(roughness), 0.98 * error) << "roughness " << roughness;
  }
}

class BenchRefusals : public ::testing::Test {
 protected:
  void expectRefused(std::vector<std::string> arguments, const std::string& mentioned) {
    arguments.insert(arguments.begin(), "bench");
    arguments.insert(arguments.end(), {"-o", folder.path("out")});
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
    ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(mentioned));
    EXPECT_FALSE(std::filesystem::exists(folder.path("out/bench.json")));
  }
  TemporaryFolder folder;
};

TEST_F(BenchRefusals, SayWhatIsWrong) {
  expectRefused({demoScene("room"), "--techniques", "mirror"}, "--techniques mirror: no such technique; there are: ");
  expectRefused({demoScene("room"), "--roughness", "0.5,2"}, "--roughness 0.5,2: expected numbers from 0 to 1");
  expectRefused({demoScene("room"), "--camera", "attic"}, "--camera attic: no camera of that name");
  expectRefused({demoScene("building"), "--materials", "stone"},
                "--materials stone: no reflecting material of that name; the scene has: mirror, sphere");
  expectRefused({demoScene("room"), "--size", "0x9"}, "--size 0x9");
  const std::string file = folder.write("file", "");
  const Outcome outcome = runProgram({"bench", demoScene("room"), "-o", file});
  EXPECT_EQ(outcome.exitStatus, 2);
  EXPECT_THAT(outcome.err, HasSubstr("this is a file; -o names a folder"));
}

TEST_F(BenchRefusals, SceneWithNothingToMeasure) {
  folder.write("plain.gltf", triangleGltf());
  const std::string start = R"({"format": "boxprobe-scene", "version": 1, "model": "plain.gltf")";
  const std::string none = folder.write("none.boxprobe.json", start + "}");
  expectRefused({none, "--quick"}, "the scene has no probe");
  const std::string matt =
      folder.write("matt.boxprobe.json",
                   start + R"(, "materials": {"paint": {"metallic": 0, "roughness": 1}}, "probes": [{"name": "p"}]})");
  expectRefused({matt, "--quick"}, "the scene has no reflecting surface");
}

TEST(Bench, InterruptedLeavesWhatItHasUnderAnotherName) {
  const TemporaryFolder folder;
  // Small pictures: of many short steps, each of which asks for signals.
  RunningProgram program({"bench", demoScene("gallery"), "-o", folder.path("out"), "--size", "160x90"});
  ASSERT_TRUE(program.waitForProgress(1)) << program.finish().err;
  ASSERT_TRUE(program.sendAtWork(SIGINT)) << "done before the signal";
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exitStatus, 1) << outcome.err;
  ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("bench.json.partial"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("out/bench.json")));
  EXPECT_EQ(parsed(folder.path("out/bench.json.partial"))["complete"], false);
}

}  // namespace
}  // namespace boxprobe::test
