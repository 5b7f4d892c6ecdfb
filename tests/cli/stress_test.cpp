// `boxprobe stress` from outside: a line for each class and technique, a worst input that can be replayed, the exit
// status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "filters/math/technique/technique_table.h"
#include "filters/stress/stress_classes.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::vector<nlohmann::json> linesOf(const std::string& text) {
  std::vector<nlohmann::json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

TEST(StressCommand, ALineForEveryClassAndTechnique) {
  const Outcome outcome = runProgram({"stress", "--count", "40000"}, DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  std::set<std::pair<std::string, std::string>> cells;
  std::uint64_t count = 0;
  for (const nlohmann::json& line : linesOf(outcome.out)) {
    cells.emplace(line.at("class"), line.at("technique"));
    count += line.at("count").get<std::uint64_t>();
    EXPECT_EQ(line.at("nonFinite"), 0);
  }
  EXPECT_EQ(count, 40000u);
  for (const stress::StressClass& c : stress::stressClasses()) {
    for (std::size_t p = 0; p < projectionRows().size(); ++p) {
      for (std::size_t e = 0; e < evaluationRows().size(); ++e) {
        EXPECT_EQ(cells.count({std::string(c.id), techniqueId({static_cast<int>(p), static_cast<int>(e)})}), 1u);
      }
    }
  }
  EXPECT_THAT(outcome.err, HasSubstr("far-1e7"));  // the table
}

TEST(StressCommand, SameInputsForTheSameSeed) {
  const std::vector<std::string> arguments = {"stress", "--quiet", "--count", "5000", "--technique", "box", "--seed"};
  const auto run = [&](const char* seed) {
    std::vector<std::string> all = arguments;
    all.emplace_back(seed);
    return runProgram(all, DisplayKind::Unset);
  };
  const Outcome once = run("3");
  EXPECT_EQ(once.err, "");
  EXPECT_EQ(once.out, run("3").out);
  EXPECT_NE(once.out, run("4").out);
}

TEST(StressCommand, TheWorstInputIsReplayed) {
  const Outcome outcome = runProgram({"stress", "--quiet", "--count", "3000", "--class", "on-face", "--class",
                                      "not-finite", "--technique", "box", "--technique", "published:box-max"},
                                     DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  const auto lines = linesOf(outcome.out);
  ASSERT_THAT(lines, SizeIs(4));
  for (const nlohmann::json& line : lines) {
    const Outcome replay = runProgram({"stress", "--replay", line.at("replay")}, DisplayKind::Unset);
    EXPECT_EQ(replay.exitStatus, 0) << replay.err;
    for (const char* step : {"position.x", "N.V", "hit", "exact"}) EXPECT_THAT(replay.out, HasSubstr(step));
    const bool bad = line.at("nonFinite") > 0;
    EXPECT_THAT(replay.out, HasSubstr(bad ? "NaN or infinite" : "every result is a number"));
  }
  EXPECT_GT(lines[3].at("nonFinite"), 0);  // what has no guard does break
}

TEST(StressCommand, FileAndTable) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"stress", "--published", "--count", "20000", "-o", folder.path("published.json")},
                                     DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("published:box-select: visibly wrong"));
  EXPECT_FALSE(linesOf(readFile(folder.path("published.json"))).empty());
}

TEST(StressCommand, RefusesWhatThereIsNot) {
  const auto error = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = runProgram(arguments, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2);
    EXPECT_THAT(outcome.errLines(), SizeIs(1));
    return outcome.err;
  };
  EXPECT_THAT(error({"stress", "--class", "nowhere"}), HasSubstr("there are: inside"));
  EXPECT_THAT(error({"stress", "--technique", "term:nothing"}), HasSubstr("term:footprint-scale"));
  EXPECT_THAT(error({"stress", "--replay", "inside box 1 2 3"}), HasSubstr("numbers"));
  EXPECT_THAT(error({"stress", "--replay", "inside box 1 two"}), HasSubstr("two"));
  EXPECT_THAT(error({"stress", "--count", "0"}), HasSubstr("--count"));
}

TEST(StressCommand, StopsWhenInterrupted) {
  const TemporaryFolder folder;
  RunningProgram program({"stress", "--count", "1000000000", "-o", folder.path("stress.json")}, DisplayKind::Unset);
  ASSERT_TRUE(program.waitUntilHandling(SIGINT));
  ASSERT_TRUE(program.sendAtWork(SIGINT));
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exitStatus, 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_THAT(folder.names(), SizeIs(0));
}

}  // namespace
}  // namespace boxprobe::test
