// Ctrl-C during long work: one line, exit status 1, nothing half written, what was there before untouched.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Enough capture work for tens of seconds of software OpenGL.
std::vector<std::string> longRender(const std::string& output) {
  const Outcome info = runProgram({"info", "--json", demoScene("room")}, DisplayKind::Unset);
  const std::string probe = nlohmann::json::parse(info.out)["probes"][0]["name"].get<std::string>();
  return {"render", demoScene("room"),
          "-o",     output,
          "--set",  "probes." + probe + ".faceSize=1024",
          "--set",  "probes." + probe + ".bounces=5"};
}

void expectStopped(RunningProgram& program, int signal, std::chrono::milliseconds delay) {
  ASSERT_TRUE(program.waitUntilHandling(signal));
  std::this_thread::sleep_for(delay);
  ASSERT_TRUE(program.sendAtWork(signal)) << "done before the signal: " << program.finish().err;
  const Outcome outcome = program.finish();
  // 1: stopped between two steps; else in the middle of one that took long.
  EXPECT_THAT(outcome.exitStatus, AnyOf(1, 128 + signal)) << outcome.err;
  ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
}

TEST(Interrupt, LeavesNoFile) {
  const TemporaryFolder folder;
  for (const int delay : {0, 300, 1500}) {
    SCOPED_TRACE(delay);
    RunningProgram program(longRender(folder.path("out.png")));
    expectStopped(program, SIGINT, std::chrono::milliseconds(delay));
    EXPECT_THAT(folder.names(), SizeIs(0));
  }
}

// Between the frames of a mean, which are so many that all of them take minutes.
TEST(Interrupt, StopsBetweenFrames) {
  const TemporaryFolder folder;
  RunningProgram program({"render", demoScene("room"), "-o", folder.path("mean.exr"), "--size", "32x18", "--frames",
                          "100000", "--technique", "raytraced", "--set",
                          "probes.room.parameters={\"animated\":true,\"samples\":2}", "--set",
                          "probes.room.faceSize=16"});
  ASSERT_TRUE(program.waitUntilHandling(SIGINT));
  std::this_thread::sleep_for(std::chrono::milliseconds(6000));  // captures or frames: both are short
  ASSERT_TRUE(program.sendAtWork(SIGINT));
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exitStatus, 1) << "in no step that takes long: " << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_THAT(folder.names(), SizeIs(0));
}

TEST(Interrupt, LeavesTheFileThatWasThere) {
  const TemporaryFolder folder;
  folder.write("out.png", "an older picture");
  RunningProgram program(longRender(folder.path("out.png")));
  expectStopped(program, SIGTERM, std::chrono::milliseconds(500));
  EXPECT_THAT(folder.names(), ElementsAre("out.png"));
  EXPECT_EQ(readFile(folder.path("out.png")), "an older picture");
}

/// False: the command was done before the signal.
bool stopAfter(int milliseconds, const std::vector<std::string>& command, int signal, Outcome& outcome) {
  RunningProgram program(command);
  if (!program.waitUntilHandling(signal)) return false;
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  if (!program.sendAtWork(signal)) return false;
  outcome = program.finish();
  // What arrives with the last of the work is told of, and the work is whole.
  const bool whole =
      outcome.exitStatus == 1 && outcome.err.find("what was asked for was done by then") != outcome.err.npos;
  return !whole;
}

// Where nothing asks: reading a model, an integral of a lesson, a stress run's report. Each has work for many times the
// delay, and would end with 0. How soon each ends is measured by tests/stress/signals.py.
TEST(Interrupt, EveryCommandEndsByTheSignalAndNeverWithZero) {
  const auto commands = [](const TemporaryFolder& folder) {
    return std::vector<std::vector<std::string>>{{"lessons", "floor-mirror", "-o", folder.path("l.png")},
                                                 {"lessons", "--check", "--quiet"},
                                                 {"info", demoScene("building"), "--frame", "--quiet"},
                                                 {"stress", "--count", "1e9", "--quiet", "-o", folder.path("s.json")},
                                                 {"bench", demoScene("room"), "-o", folder.path("bench"), "--quiet"},
                                                 {"bench", "--truth", "--quiet", "-o", folder.path("truth")}};
  };
  const std::size_t count = commands(TemporaryFolder()).size();
  for (std::size_t i = 0; i < count; ++i) {
    int delay = 200;
    for (const int signal : {SIGTERM, SIGHUP}) {
      SCOPED_TRACE("command " + std::to_string(i) + ", signal " + std::to_string(signal));
      // A fast machine may be done before the signal: then it comes sooner, and finds an empty folder.
      for (bool caught = false; !caught; delay /= 2) {
        ASSERT_GT(delay, 0) << "never caught at work";
        const TemporaryFolder folder;
        Outcome outcome;
        caught = stopAfter(delay, commands(folder)[i], signal, outcome);
        if (!caught) continue;
        EXPECT_THAT(outcome.exitStatus, AnyOf(1, 128 + signal)) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
        for (const std::string& name : folder.names()) EXPECT_THAT(name, AnyOf("bench", "truth"));
      }
      delay = 800;
    }
  }
}

TEST(Interrupt, AWindowEndsWithTheSignalsStatus) {
  RunningProgram program({demoScene("room")});
  ASSERT_TRUE(program.waitUntilHandling(SIGTERM));
  ASSERT_TRUE(program.sendAtWork(SIGTERM));
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exitStatus, 128 + SIGTERM) << outcome.err;
}

}  // namespace
}  // namespace boxprobe::test
