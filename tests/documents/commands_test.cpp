// Every command of every README.md is one that this tree has; those that are cheap are run. And the checks notice when
// a document is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <set>

#include "tests/cli/program.h"
#include "tests/documents/command_checks.h"
#include "tests/documents/command_runs.h"

namespace boxprobe::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kRoot = BOXPROBE_SOURCE_DIR;

std::vector<Command> allCommands() {
  std::vector<Command> all;
  for (const Readme& readme : readReadmes(kRoot)) {
    for (Command& command : commandsOf(readme)) all.push_back(std::move(command));
  }
  return all;
}

std::string textOf(const Command& command) {
  std::string text = command.name;
  for (const std::string& word : command.arguments) text += ' ' + word;
  return text;
}

class DocumentedCommands : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::current_path(kRoot); }
  CommandChecks checks_{kRoot, readBuiltPrograms(BOXPROBE_PROGRAM_LIST)};

  std::vector<std::string> problems(const std::string& line) const {
    return checks_.problems(commandOf({"a.md", 1}, line));
  }
};

TEST_F(DocumentedCommands, AreRight) {
  const std::vector<Command> commands = allCommands();
  EXPECT_GT(commands.size(), 60u);
  for (const Command& command : commands) {
    EXPECT_THAT(checks_.problems(command), IsEmpty()) << command.place.text() << ": " << textOf(command);
  }
}

TEST_F(DocumentedCommands, CheapOnesRun) {
  std::set<std::string> done;
  for (const Command& command : allCommands()) {
    if (!isCheap(command)) continue;
    const TemporaryFolder folder;
    EXPECT_EQ(runCommand(command, folder.path("")), "") << command.place.text() << ": " << textOf(command);
    done.insert(command.kind == CommandKind::Program ? subcommandOf(command) : command.name);
  }
  for (const char* command : {"render", "info", "explain", "bake", "stress", "lessons"}) {
    EXPECT_EQ(done.count(command), 1u) << "no document shows a cheap example of " << command;
  }
}

/// The program of the first README: its picture is that of `boxprobe render`.
TEST_F(DocumentedCommands, TheExampleDrawsTheScene) {
  const TemporaryFolder folder;
  const std::string scene = demoScene("room"), example = folder.path("example.png"), rendered = folder.path("room.png");
  const std::string line = std::string(BOXPROBE_SCENE_EXAMPLE) + " '" + scene + "' '" + example + "'";
  ASSERT_EQ(std::system(line.c_str()), 0);
  ASSERT_EQ(runProgram({"render", scene, "-o", rendered, "--size", "640x360", "--samples", "1"}).exitStatus, 0);
  EXPECT_FALSE(readFile(example).empty());
  EXPECT_EQ(readFile(example), readFile(rendered));
}

TEST_F(DocumentedCommands, AWrongOneIsNoticed) {
  EXPECT_THAT(problems("boxprobe render data/scenes/room.boxprobe.json -o a.png --hurry"),
              ElementsAre(HasSubstr("has no --hurry")));
  EXPECT_THAT(problems("boxprobe info data/scenes/attic.boxprobe.json"),
              ElementsAre(HasSubstr("no file data/scenes/attic")));
  EXPECT_THAT(problems("boxprobe render SCENE -o FILE --technique cone"), ElementsAre("no technique cone"));
  EXPECT_THAT(problems("boxprobe bench -o out/bench --rooms many"), ElementsAre(HasSubstr("--rooms")));
  EXPECT_THAT(problems("boxprobe lessons no-such-lesson"), ElementsAre("no lesson no-such-lesson"));
  EXPECT_THAT(problems("build/release/tests/image/no_test"), ElementsAre(HasSubstr("the build makes no")));
  EXPECT_THAT(problems("build/release/tests/bench/bench_frame --fast"), ElementsAre(HasSubstr("has no --fast")));
  EXPECT_THAT(problems("NO_SUCH=1 build/release/tests/stress/kill_test"),
              ElementsAre(HasSubstr("does not read NO_SUCH")));
  EXPECT_THAT(problems("build/release/tests/image/bake_test --gtest_filter='Nothing*'"),
              ElementsAre(HasSubstr("has no test Nothing*")));
  EXPECT_THAT(problems("cmake --preset fast"), ElementsAre(HasSubstr("no preset")));
  EXPECT_THAT(problems("./run --setup-all"), ElementsAre(HasSubstr("has no --setup-all")));
  EXPECT_THAT(problems("build/release/fuzz/tests/fuzz/fuzz_sound"), ElementsAre("no fuzzer of sound"));
  EXPECT_THAT(problems("tests/bench/last_frame.sh"), ElementsAre(HasSubstr("no script")));
  EXPECT_THAT(problems("tests/bench/first_frame.sh --slowly"), ElementsAre(HasSubstr("has no --slowly")));
  EXPECT_THAT(problems("ninja -C build/release no_program"), ElementsAre("no program no_program"));
  EXPECT_THAT(problems("make all"), ElementsAre(HasSubstr("no command that this test knows")));
}

TEST_F(DocumentedCommands, AreTakenApartAsAShellDoes) {
  EXPECT_THAT(shellWords("a \"b c\"d 'e # f' #g # h"), ElementsAre("a", "b cd", "e # f"));
  const Command command =
      commandOf({"a.md", 1}, "A=1 xvfb-run -a -s \"-screen 0\" build/release/x [--seed S] --set a=[1,2]");
  EXPECT_EQ(command.name, "build/release/x");
  EXPECT_THAT(command.arguments, ElementsAre("--seed", "S", "--set", "a=[1,2]"));
  EXPECT_EQ(command.environment.at("A"), "1");
  EXPECT_FALSE(command.example);
}

}  // namespace
}  // namespace boxprobe::test
