// --help of the program and of every sub-command names its options and gives an example that works.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

Outcome help(const std::vector<std::string>& arguments) {
  Outcome outcome = runProgram(arguments, DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 0);
  EXPECT_EQ(outcome.err, "");
  return outcome;
}

TEST(Help, ProgramNamesItsSubcommands) {
  const Outcome outcome = help({"--help"});
  for (const char* text :
       {"render", "info", "SCENE", "--version", "Example", "boxprobe data/scenes/building.boxprobe.json"}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

TEST(Help, RenderNamesItsOptions) {
  const Outcome outcome = help({"render", "--help"});
  for (const char* text : {"--output", "--size", "--camera", "--technique", "--samples", "--probes", "--frames",
                           "--set", "--stats", "--json", "--quiet", "Example", "boxprobe render "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

TEST(Help, BenchNamesItsOptions) {
  const Outcome outcome = help({"bench", "--help"});
  for (const char* text : {"--output", "--quick", "--techniques", "--roughness", "--camera", "--size", "--seed",
                           "--set", "--stats", "--json", "--quiet", "Example", "boxprobe bench "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

TEST(Help, InfoNamesItsOptions) {
  const Outcome outcome = help({"info", "--help"});
  for (const char* text : {"SCENE", "--set", "--fields", "--stats", "--json", "--quiet", "Example", "boxprobe info "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

TEST(Help, FitNamesItsOptions) {
  const Outcome outcome = help({"fit", "--help"});
  for (const char* text : {"SCENE", "--probe", "--origin", "--faces", "--yaw", "--output", "--set", "--json", "--quiet",
                           "Example", "boxprobe fit "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

TEST(Help, PlaceNamesItsOptions) {
  const Outcome outcome = help({"place", "--help"});
  for (const char* text : {"SCENE", "--output", "--most", "--gain", "--keep", "--as", "--set", "--json", "--quiet",
                           "Example", "boxprobe place "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

TEST(Help, ReportNamesItsOptionsAndExitStatuses) {
  const Outcome outcome = help({"report", "--help"});
  for (const char* text : {"SCENE...", "--output", "--fail-above", "--camera", "--technique", "--size", "--rays",
                           "--quick", "--seed", "--set", "--json", "--quiet", "Exit status: 0", "boxprobe report "}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

TEST(Help, Version) {
  EXPECT_THAT(help({"--version"}).out, MatchesRegex("boxprobe [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

}  // namespace
}  // namespace boxprobe::test
