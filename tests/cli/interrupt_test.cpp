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
  program.send(signal);
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exitStatus, 1) << outcome.err;
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

TEST(Interrupt, LeavesTheFileThatWasThere) {
  const TemporaryFolder folder;
  folder.write("out.png", "an older picture");
  RunningProgram program(longRender(folder.path("out.png")));
  expectStopped(program, SIGTERM, std::chrono::milliseconds(500));
  EXPECT_THAT(folder.names(), ElementsAre("out.png"));
  EXPECT_EQ(readFile(folder.path("out.png")), "an older picture");
}

}  // namespace
}  // namespace boxprobe::test
