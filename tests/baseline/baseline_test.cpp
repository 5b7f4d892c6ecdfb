// The program's commands, run one after another, against the numbers in baseline.json. README.md says how to write
// them anew after a change that is wanted.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>

#include "tests/baseline/baseline_runs.h"
#include "tests/baseline/baseline_scenes.h"
#include "tests/baseline/baseline_values.h"
#include "tests/cli/program.h"

namespace boxprobe::test {

static void PrintTo(const BaselineRun& run, std::ostream* stream) {
  *stream << run.command;
}

namespace {

const std::string kFolder = std::string(BOXPROBE_SOURCE_DIR) + "/tests/baseline/";
const std::string kFile = kFolder + "baseline.json", kOtherFile = kFolder + "other_machine.json";

enum class Writes { Nothing, All, OtherMachine };

Writes writes = Writes::Nothing;
BaselineJson kept = BaselineJson::object(), other = BaselineJson::object(), made = BaselineJson::object();
std::unique_ptr<TemporaryFolder> scenes;

/// The arguments, with the scene's file in place of its name.
std::vector<std::string> argumentsOf(const BaselineRun& run) {
  const auto replace = [](std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what))
      text.replace(at, what.size(), by);
    return text;
  };
  std::vector<std::string> arguments;
  std::istringstream words(run.command);
  for (std::string word; words >> word;) {
    word = replace(replace(word, "SKY", std::string(BOXPROBE_DATA_DIR) + "/scenes/sky.hdr"), "X20", " ");
    arguments.push_back(word);
  }
  std::string& scene = arguments.at(1);
  const std::string own = scenes->path(scene.find('.') == std::string::npos ? scene + ".boxprobe.json" : scene);
  scene = std::ifstream(own).good() ? own : demoScene(scene);
  if (arguments[0] == "render" && run.command.find("--size") == std::string::npos) {
    arguments.insert(arguments.end(), {"--size", "48x27"});
  }
  return arguments;
}

BaselineJson valuesOf(const BaselineRun& run) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = argumentsOf(run);
  if (!run.output.empty()) arguments.insert(arguments.end(), {"-o", folder.path(run.output), "--quiet"});
  const Outcome outcome = runProgram(arguments);
  EXPECT_EQ(outcome.exitStatus, 0) << run.command << ": " << outcome.err;
  if (outcome.exitStatus != 0) return {};
  const std::string place = folder.path(""), own = scenes->path("");
  BaselineJson values = run.output.empty() ? printedValues(outcome.out, own.substr(0, own.size() - 1))
                                           : writtenValues(folder.path(run.output), place.substr(0, place.size() - 1));
  return values;
}

class Baseline : public ::testing::TestWithParam<BaselineRun> {};

TEST_P(Baseline, IsAsBefore) {
  const BaselineRun& run = GetParam();
  const BaselineJson values = valuesOf(run);
  if (writes == Writes::All) {
    made[run.name] = values;
    return;
  }
  ASSERT_TRUE(kept.contains(run.name)) << "not in baseline.json; see README.md";
  const std::vector<std::string> found = differences(kept[run.name], values, run.drawn);
  if (writes == Writes::OtherMachine) {
    made[run.name] = found.empty() ? BaselineJson() : values;
    return;
  }
  if (other.contains(run.name) && differences(other[run.name], values, run.drawn).empty()) return;
  std::string text;
  for (std::size_t i = 0; i < found.size() && i < 12; ++i) text += "\n  " + run.name + found[i];
  EXPECT_TRUE(found.empty()) << found.size() << " values differ from tests/baseline/baseline.json:" << text
                             << "\nboxprobe " << run.command
                             << "\nIf that is wanted, tests/baseline/README.md says how to write them anew.";
}

INSTANTIATE_TEST_SUITE_P(All, Baseline, ::testing::ValuesIn(baselineRuns()),
                         [](const ::testing::TestParamInfo<BaselineRun>& instance) {
                           std::string name;
                           for (const char c : instance.param.name)
                             name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                           return name;
                         });

TEST(BaselineValues, ADifferenceIsNamedWithItsSize) {
  const BaselineJson expected = {{"box", {{"min", {1.5, 2.0}}}}, {"name", "a"}};
  BaselineJson actual = expected;
  EXPECT_TRUE(differences(expected, actual, false).empty());
  actual["box"]["min"][1] = 2.0001;
  actual["name"] = "b";
  const std::vector<std::string> found = differences(expected, actual, false);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], "/box/min/1: 2.0 is 2.0001 (0.005 %)");
  EXPECT_EQ(found[1], "/name: \"a\" is \"b\"");
  EXPECT_EQ(differences(expected, actual, true).size(), 1u);
}

TEST(BaselineValues, OfAPictureThreePlacesMayDiffer) {
  BaselineJson expected = {{"size", {16, 9}}, {"mean", 0.5}, {"thousandths", std::vector<int>(36, 1000)}};
  BaselineJson actual = expected;
  for (int i = 0; i < 3; ++i) actual["thousandths"][static_cast<std::size_t>(3 * i)] = 1020;
  EXPECT_TRUE(differences(expected, actual, true).empty());
  actual["thousandths"][9] = 1020;
  EXPECT_EQ(differences(expected, actual, true).size(), 1u);
  actual = expected;
  actual["mean"] = 0.5015;
  EXPECT_EQ(differences(expected, actual, true).size(), 1u);
}

}  // namespace
}  // namespace boxprobe::test

int main(int argc, char** argv) {
  using namespace boxprobe::test;
  ::testing::InitGoogleTest(&argc, argv);
  const std::string asked = argc > 1 ? argv[1] : "";
  if (asked == "--write") writes = Writes::All;
  if (asked == "--write-other-machine") writes = Writes::OtherMachine;
  if (std::ifstream stream(kFile); stream) kept = BaselineJson::parse(stream);
  if (std::ifstream stream(kOtherFile); stream) other = BaselineJson::parse(stream);
  scenes = std::make_unique<TemporaryFolder>();
  writeBaselineScenes(scenes->path(""));
  const int result = RUN_ALL_TESTS();
  if (writes != Writes::Nothing && result == 0) {
    // In the order of the runs; those that a filter has left out stay as they are, and null is nothing to keep.
    const bool all = writes == Writes::All;
    BaselineJson written = BaselineJson::object();
    const BaselineJson& before = all ? kept : other;
    for (const BaselineRun& run : baselineRuns()) {
      const BaselineJson& from = made.contains(run.name) ? made : before;
      if (from.contains(run.name) && !from[run.name].is_null()) written[run.name] = from[run.name];
    }
    const std::string& file = all ? kFile : kOtherFile;
    std::ofstream(file) << baselineText(written);
    std::printf("%s: %zu runs\n", file.c_str(), written.size());
  }
  scenes.reset();
  return result;
}
