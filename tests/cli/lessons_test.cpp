// `boxprobe lessons`: list, sheet, page, claims, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(LessonsCommand, ListsWithoutADisplay) {
  const Outcome text = runProgram({"lessons"}, DisplayKind::Unset);
  EXPECT_EQ(text.exitStatus, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("floor-mirror"));
  const Outcome outcome = runProgram({"lessons", "--json"}, DisplayKind::Unset);
  const json list = json::parse(outcome.out);
  EXPECT_GE(list["lessons"].size(), 28u);
  EXPECT_TRUE(list["errors"].empty()) << list["errors"];
}

TEST(LessonsCommand, DrawsASheetAndHoldsTheLessonToItsClaims) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"lessons", "floor-mirror", "-o", folder.path("sheet.png"), "--json"});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  const json claims = json::parse(outcome.out);
  ASSERT_FALSE(claims.empty());
  EXPECT_TRUE(claims[0]["holds"]);
  EXPECT_THAT(readFile(folder.path("sheet.png")), StartsWith("\x89PNG"));
}

TEST(LessonsCommand, DrawsAPageThatNeedsNothingBesideIt) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"lessons", "fresnel", "-o", folder.path("page.html"), "--quiet"});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const std::string page = readFile(folder.path("page.html"));
  EXPECT_THAT(page, HasSubstr("data:image/jpeg;base64,"));
  EXPECT_THAT(page, HasSubstr("<math"));
  EXPECT_THAT(page, Not(HasSubstr("does not hold")));
  EXPECT_THAT(page, EndsWith("</html>\n"));
}

TEST(LessonsCommand, AFalseClaimIsAFailure) {
  const TemporaryFolder folder;
  folder.write("1-false.lesson.json", R"({"format": "boxprobe-lesson", "version": 1, "title": "T", "chapter": "C",
    "summary": "S", "scene": ")" + demoScene("six-faces") +
                                          R"(", "steps": [{"title": "t", "say": "s"}],
    "claims": [{"say": "It is dark.", "measure": {"kind": "mean", "step": 1}, "below": 0}]})");
  const Outcome outcome = runProgram({"lessons", "--check", "--folder", folder.path("")});
  EXPECT_EQ(outcome.exitStatus, 1);
  EXPECT_THAT(outcome.out, HasSubstr("DOES NOT HOLD"));
  EXPECT_EQ(outcome.errLines().size(), 1u) << outcome.err;
}

TEST(LessonsCommand, BadUseIsOneLine) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"lessons", "flor-mirror"},
                                                    {"lessons", "-o", folder.path("all.png")},
                                                    {"lessons", "floor-mirror", "-o", folder.path("sheet.tiff")},
                                                    {"lessons", "--folder", folder.path("none")}}) {
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.exitStatus, 2) << arguments.back();
    EXPECT_EQ(outcome.errLines().size(), 1u) << outcome.err;
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(LessonsCommand, ABrokenLessonIsToldAndTheOthersList) {
  const TemporaryFolder folder;
  folder.write("1-broken.lesson.json", "{\"format\": 1}");
  folder.write("2-whole.lesson.json", R"({"format": "boxprobe-lesson", "version": 1, "title": "Whole", "chapter": "C",
    "summary": "S", "scene": ")" + demoScene("six-faces") +
                                          R"(", "steps": [{"title": "t", "say": "s"}]})");
  const Outcome outcome = runProgram({"lessons", "--folder", folder.path("")}, DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 0);
  EXPECT_THAT(outcome.out, HasSubstr("Whole"));
  EXPECT_THAT(outcome.err, HasSubstr("1-broken.lesson.json"));
}

}  // namespace
}  // namespace boxprobe::test
