// `bench --truth`: rows that agree with the printed table, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const std::string kTruthFolder = BOXPROBE_SOURCE_DIR "/tests/truth/";

TEST(TruthBench, RowsOfReferencesAndTechniques) {
  const TemporaryFolder folder;
  const Outcome outcome =
      runProgram({"bench", kTruthFolder + "scenes/empty.boxprobe.json", "--truth", "--quick", "--techniques",
                  "footprint8", "--camera", "steep", "--roughness", "0.5", "-o", folder.path("out")});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(readFile(folder.path("out/truth.json")));
  EXPECT_EQ(json["complete"], true);
  EXPECT_THAT(json["renderer"], HasSubstr("Blender"));
  std::map<std::string, std::map<std::string, double>> errors;  // by technique and kind
  for (const auto& row : json["rows"]) {
    EXPECT_EQ(row["scene"], "empty");
    EXPECT_EQ(row["camera"], "steep");
    EXPECT_EQ(row["roughness"], 0.5);
    EXPECT_EQ(row["reference"], "truth");
    EXPECT_GT(row["noise"], 0.0);
    EXPECT_GT(row["pixels"], 0);
    double pixels = 0.0;
    for (const auto& bucket : row["buckets"]) pixels += bucket["pixels"].get<double>();
    EXPECT_EQ(pixels, row["pixels"].get<double>());
    const std::string technique = row["technique"], kind = row["kind"];
    errors[technique][kind] = row["relativeRmse"];
    EXPECT_EQ(row.contains("holds"), technique.rfind("reference-", 0) == 0) << technique;
    // The file's numbers are rounded already: where they end in 5, the table may go either way.
    std::vector<std::string> cells;
    for (const double nudge : {-1e-7, 1e-7}) {
      char cell[32];
      std::snprintf(cell, sizeof(cell), "%.3f %.4f", row["meanLight"].get<double>(), errors[technique][kind] + nudge);
      cells.emplace_back(cell);
    }
    EXPECT_THAT(outcome.out, AnyOf(HasSubstr(cells[0]), HasSubstr(cells[1]))) << technique << ", " << kind;
  }
  ASSERT_THAT(errors, SizeIs(5)) << "two references, footprint8, and the two baselines";
  for (const char* kind : {"metal", "dielectric"}) {
    EXPECT_LT(errors["reference-box"][kind], errors["footprint8"][kind]);
    EXPECT_LT(errors["footprint8"][kind], errors["box"][kind]);
  }
}

TEST(TruthBench, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const auto expectRefused = [&](std::vector<std::string> arguments, const std::string& mentioned) {
    arguments.insert(arguments.begin(), "bench");
    arguments.insert(arguments.end(), {"-o", folder.path("out")});
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
    ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(mentioned));
    EXPECT_FALSE(std::filesystem::exists(folder.path("out/truth.json")));
  };
  expectRefused({"--truth=" + folder.path("gone.json")},
                "gone.json: there is no such file; make it with tests/truth/make.sh, which needs Blender 4.1 or later");
  const std::string empty = folder.write("empty.json", "{}");
  expectRefused({"--truth=" + empty}, "empty.json: not a truth file");
  expectRefused({"--truth", BOXPROBE_DATA_DIR "/scenes/room.boxprobe.json"},
                "there are no truth pictures of this scene");
  expectRefused({"--truth", "--camera", "attic"}, "no truth picture has such a camera");
  expectRefused({"--truth", "--roughness", "0.3"}, "no truth picture has such a camera and roughness");
  expectRefused({"--truth", "--size", "64x36"}, "--size is not for --truth");
  expectRefused({"--truth", "--set", "exposure=2"}, "--set is not for --truth");
}

}  // namespace
}  // namespace boxprobe::test
