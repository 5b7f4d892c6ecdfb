// `boxprobe render --refine` in its forms, and what it refuses. Needs a display (CTest starts a virtual one).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "filters/io/image/image_file.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class Refine : public ::testing::Test {
 protected:
  Outcome render(const std::string& output, const std::vector<std::string>& more, const char* size = "96x54") {
    std::vector<std::string> arguments = {"render", demoScene("room"), "-o", folder.path(output), "--size",
                                          size,     "--samples",       "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments);
  }
  TemporaryFolder folder;
};

TEST_F(Refine, WritesAPictureAndSaysWhatIsLeft) {
  const std::vector<std::string> rough = {"--set", "materials.floor.roughness=0.3", "--set", "probes.room.faceSize=64"};
  const auto with = [&](const char* option) {
    std::vector<std::string> all = rough;
    all.emplace_back(option);
    return all;
  };
  const Outcome plain = render("plain.png", rough);
  const Outcome refined = render("refined.png", with("--refine"));
  ASSERT_EQ(refined.exitStatus, 0) << refined.err;
  EXPECT_THAT(refined.out, HasSubstr("refined by 256 rays a pixel, an estimated "));
  EXPECT_EQ(plain.out.find("refined by"), std::string::npos);
  const Outcome again = render("again.png", with("--refine=256"));
  EXPECT_EQ(loadImage8(folder.path("refined.png")).pixels, loadImage8(folder.path("again.png")).pixels);
  EXPECT_NE(loadImage8(folder.path("refined.png")).pixels, loadImage8(folder.path("plain.png")).pixels);

  const Outcome fewer = render("fewer.exr", with("--refine=20"));
  ASSERT_EQ(fewer.exitStatus, 0) << fewer.err;
  EXPECT_THAT(fewer.out, HasSubstr("refined by 20 rays"));
  const Outcome percent = render("percent.png", with("--refine=40%"));
  ASSERT_EQ(percent.exitStatus, 0) << percent.err;
  EXPECT_EQ(percent.err.find("not reached"), std::string::npos) << percent.err;
}

TEST_F(Refine, SaysWhatItReachedOfAPercentageThatCannotBe) {
  const Outcome outcome = render(
      "out.png", {"--refine=0.0001%", "--set", "probes.room.faceSize=16", "--set", "materials.floor.roughness=0.6"},
      "24x14");
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("refined by 16384 rays a pixel, an estimated "));
  ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("--refine=0.0001 %: not reached; after 16384 rays a pixel, the most there are"));
}

TEST_F(Refine, SaysThatAViewOfARealtimeProbeNeverRests) {
  const Outcome outcome = render("out.png", {"--refine=16", "--set", "probes.room.mode=realtime", "--set",
                                             "materials.floor.roughness=0.3", "--set", "probes.room.faceSize=32"});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("refined by 16 rays a pixel"));
  ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("room is realtime, so that a window never rests"));
}

TEST_F(Refine, RefusesWhatItCannotDoInOneLine) {
  for (const char* option : {"--refine=0", "--refine=1000000000", "--refine=1e9", "--refine=-4", "--refine=2.5",
                             "--refine=0%", "--refine=100%", "--refine=many", "--refine=%", "--refine=nan%"}) {
    const Outcome outcome = render("out.png", {option});
    EXPECT_EQ(outcome.exitStatus, 2) << option;
    ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(std::string(option) + ": expected a number of rays from 1 to 16384"));
  }
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"--refine", "--view", "lookups"}, {"--refine", "--frames", "3"}, {"--refine", "--probes", "off"}}) {
    const Outcome outcome = render("out.png", more);
    EXPECT_EQ(outcome.exitStatus, 2) << more[1];
    ASSERT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("--refine beside " + more[1]));
  }
  const Outcome reference = render("out.png", {"--refine", "--technique", "reference-path"});
  EXPECT_EQ(reference.exitStatus, 2) << reference.err;
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace boxprobe::test
