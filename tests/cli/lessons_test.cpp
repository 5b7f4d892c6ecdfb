// `boxprobe lessons`: list, sheet, page, claims, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(LessonsCommand, ListsWithoutADisplay) {
  const Outcome text = runProgram({"lessons"}, DisplayKind::Unset);
  EXPECT_EQ(text.exitStatus, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("floor-mirror"));
  const Outcome outcome = runProgram({"lessons", "--json"}, DisplayKind::Unset);
  const json list = json::parse(outcome.out);
  EXPECT_FALSE(list["language"].get<std::string>().empty());
  EXPECT_TRUE(list["textErrors"].empty()) << list["textErrors"];
  EXPECT_EQ(list["lessons"].size(), 22u);  // twenty and two of the appendix
  EXPECT_TRUE(list["errors"].empty()) << list["errors"];
  // Titles stand below each other.
  std::set<std::size_t> columns;
  for (const json& lesson : list["lessons"]) {
    const std::string name = "\n  " + lesson["name"].get<std::string>() + " ";
    const std::size_t line = text.out.find(name);
    ASSERT_NE(line, std::string::npos) << name;
    const std::size_t title = text.out.find(lesson["title"].get<std::string>(), line + name.size());
    ASSERT_NE(title, std::string::npos) << name;
    columns.insert(title - line);
  }
  EXPECT_EQ(columns.size(), 1u);
}

// In a locale with a decimal comma, if the system can make one: Qt takes it from the environment.
TEST(LessonsCommand, DrawsASheetAndHoldsTheLessonToItsClaims) {
  const TemporaryFolder folder, locales;
  const std::string comma = "localedef -i de_DE -f UTF-8 '" + locales.path("de_DE.UTF-8") + "' >/dev/null 2>&1";
  const bool made = std::system(comma.c_str()) == 0;
  if (made) ::setenv("LOCPATH", locales.path(".").c_str(), 1);
  if (made) ::setenv("LC_ALL", "de_DE.UTF-8", 1);
  const Outcome outcome =
      runProgram({"lessons", "floor-mirror", "-o", folder.path("sheet.png"), "--json", "--language", "en"});
  ::unsetenv("LOCPATH");
  ::unsetenv("LC_ALL");
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  const json claims = json::parse(outcome.out);
  ASSERT_FALSE(claims.empty());
  EXPECT_TRUE(claims[0]["holds"]);
  EXPECT_EQ(claims[0]["measured"].get<std::string>().find(','), std::string::npos) << claims[0]["measured"];
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
  // Each symbol is read out as MathML and drawn as an outline.
  EXPECT_THAT(page,
              HasSubstr(R"(<th scope="row"><span class="math"><math><mrow><mi>P</mi></mrow></math><svg aria-hidden)"));
  EXPECT_THAT(page, HasSubstr("</svg></span></th><td>the point that is shaded</td>"));
  EXPECT_THAT(page, Not(HasSubstr("does not hold")));
  EXPECT_THAT(page, EndsWith("</html>\n"));
}

TEST(LessonsCommand, APageHasThePlanAndTheRoomThatItsFolderAsksFor) {
  const TemporaryFolder folder;
  folder.write("1-one.lesson.json", R"({"format": "boxprobe-lesson", "version": 1, "title": "T", "chapter": "C",
    "summary": "S", "scene": ")" + demoScene("room") +
                                        R"(", "steps": [{"title": "t", "say": "s", "camera": "A"}], "claims": []})");
  const auto page = [&](const std::string& widgets) {
    folder.write("page.json", R"({"format": "boxprobe-lesson-page", "version": 1, )" + widgets + "}");
    return runProgram({"lessons", "one", "-o", folder.path("page.html"), "--folder", folder.path("")});
  };
  const Outcome outcome = page(R"("plans": {"one": [0.62, 0.78]}, "rooms": ["one", "two"])");
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("two: there is no such lesson"));
  const std::string text = readFile(folder.path("page.html"));
  EXPECT_THAT(text, AllOf(HasSubstr("data-plan=\""), HasSubstr("<svg"), HasSubstr("data-scene=\"scene-0\""),
                          HasSubstr("data:image/ktx2;base64,")));
  ASSERT_EQ(page(R"("rooms": ["one"], "figures": {"infinity": "one", "stand": "one"}, "sources":
    [{"title": "A & B", "address": "https://x.org/"}])")
                .exitStatus,
            0);
  EXPECT_THAT(readFile(folder.path("page.html")),
              AllOf(HasSubstr("data-figure=\"infinity\""), HasSubstr("data-figure=\"stand\""),
                    HasSubstr("<a href=\"https://x.org/\">A &amp; B</a>")));
  for (const char* widgets : {R"("plans": {"one": [0.62]})", R"("plans": {"one": [2, 0]})", R"("walls": 1)",
                              R"("rooms": ["one"], "figures": {"moon": "one"})", R"("figures": {"stand": "one"})",
                              R"("sources": [{"title": "T", "address": "http://x"}])"}) {
    const Outcome refused = page(widgets);
    EXPECT_EQ(refused.exitStatus, 2) << widgets;
    EXPECT_EQ(refused.errLines().size(), 1u) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("page.json"));
  }
}

TEST(LessonsCommand, ASheetNeedsNoDisplayAndIsTheSame) {
  const TemporaryFolder folder;
  const auto sheet = [&](const std::string& name, DisplayKind display) {
    const Outcome outcome = runProgram({"lessons", "three-distances", "-o", folder.path(name), "--quiet"}, display);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    return readFile(folder.path(name));
  };
  const std::string without = sheet("without.png", DisplayKind::Unset);
  EXPECT_GT(without.size(), 10000u);
  EXPECT_TRUE(without == sheet("with.png", DisplayKind::Inherited));
}

TEST(LessonsCommand, ExercisesStandInThePageFoldedAndAreHeldToTheirMeasure) {
  const TemporaryFolder folder;
  const auto page = [&](const std::string& limit) {
    folder.write("1-one.lesson.json",
                 R"({"format": "boxprobe-lesson", "version": 1, "title": "T", "chapter": "C",
      "summary": "S", "scene": ")" +
                     demoScene("six-faces") +
                     R"(", "steps": [{"title": "t", "say": "s"}], "exercises": [{"ask": "How bright is it?",
      "solution": "Bright & so on.", "formula": "P", "measure": {"kind": "mean", "step": 1}, )" +
                     limit + "}]}");
    return runProgram({"lessons", "one", "-o", folder.path("page.html"), "--folder", folder.path("")});
  };
  EXPECT_EQ(page(R"("above": 0)").exitStatus, 0);
  const std::string text = readFile(folder.path("page.html"));
  EXPECT_THAT(text, HasSubstr("<details><summary>Solution</summary><p>Bright &amp; so on.</p>"));
  EXPECT_THAT(text, HasSubstr("<h2>Solutions</h2>"));
  EXPECT_EQ(page(R"("below": 0)").exitStatus, 1);
  EXPECT_THAT(readFile(folder.path("page.html")), HasSubstr("does not hold"));
}

TEST(LessonsCommand, LoopsNeedTheirEncoderAndAnEntryInThePage) {
  const TemporaryFolder folder;
  folder.write("1-one.lesson.json", R"({"format": "boxprobe-lesson", "version": 1, "title": "T", "chapter": "C",
    "summary": "S", "scene": ")" + demoScene("room") +
                                        R"(", "steps": [{"title": "t", "say": "s", "camera": "A"}]})");
  const auto loops = [&](const std::string& entry) {
    folder.write("page.json", R"({"format": "boxprobe-lesson-page", "version": 1, "loops": [)" + entry + "]}");
    return runProgram({"lessons", "--loops", folder.path("out"), "--folder", folder.path("")});
  };
  const std::string good = R"("name": "l", "lesson": "one", "labels": ["a"], "say": "s", "seconds": 1, )";
  const std::string moved = R"("from": {"probes.room.origin": [0, 1, 0]}, "to": {"probes.room.origin": [1, 1, 0]}})";
  for (const auto& [entry, said] : std::vector<std::pair<std::string, std::string>>{
           {"{" + good + R"("steps": [1], "from": {"probes.room.origin": [0, 1]}, "to": {"probes.room.origin": [1]}})",
            "from.probes.room.origin"},
           {"{" + good + R"("steps": [0], )" + moved, "steps"},
           {R"({"name": "../l", "lesson": "one", "labels": ["a"], "say": "s", "steps": [1], )" + moved, "name"},
           {"", "no loop"}}) {
    const Outcome refused = loops(entry);
    EXPECT_EQ(refused.exitStatus, 2) << entry;
    EXPECT_EQ(refused.errLines().size(), 1u) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(said));
  }
  const Outcome outcome = loops("{" + good + R"("steps": [1], )" + moved);
  if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) {
    EXPECT_EQ(outcome.exitStatus, 2);
    EXPECT_THAT(outcome.err, HasSubstr("apt-get install ffmpeg"));
    return;
  }
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  const std::string film = readFile(folder.path("out/l.webm"));
  EXPECT_THAT(film, StartsWith("\x1a\x45\xdf\xa3"));  // EBML
  EXPECT_LE(film.size(), 1000000u);
}

TEST(LessonsCommand, AFalseClaimIsAFailure) {
  const TemporaryFolder folder;
  folder.write("1-false.lesson.json", R"({"format": "boxprobe-lesson", "version": 1, "title": "T", "chapter": "C",
    "summary": "S", "scene": ")" + demoScene("six-faces") +
                                          R"(", "steps": [{"title": "t", "say": "s"}],
    "claims": [{"say": "It is dark.", "measure": {"kind": "mean", "step": 1, "region": [0, 0.5, 1, 1]},
      "below": 0}]})");
  const Outcome outcome = runProgram({"lessons", "--check", "--folder", folder.path("")});
  EXPECT_EQ(outcome.exitStatus, 1);
  EXPECT_THAT(outcome.out, HasSubstr("DOES NOT HOLD"));
  EXPECT_THAT(outcome.out, HasSubstr(" in [0, 0.5, 1, 1]"));
  EXPECT_EQ(outcome.errLines().size(), 1u) << outcome.err;
}

TEST(LessonsCommand, BadUseIsOneLine) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"lessons", "flor-mirror"},
                                                    {"lessons", "-o", folder.path("all.png")},
                                                    {"lessons", "floor-mirror", "-o", folder.path("sheet.tiff")},
                                                    {"lessons", "--folder", folder.path("none")},
                                                    {"lessons", "--language", "xx"},
                                                    {"lessons", "floor-mirror", "--language", "xx"}}) {
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

TEST(LessonsCommand, ShowsTheLanguageAskedForOrTheLocales) {
  const TemporaryFolder folder;
  for (const char* name : {"1-first", "2-second"}) {
    folder.write(std::string(name) + ".lesson.json",
                 R"({"format": "boxprobe-lesson", "version": 1, "chapter": "c", "scene": ")" + demoScene("six-faces") +
                     R"(", "steps": [{"id": "one"}]})");
  }
  const auto texts = [&](const std::string& language, const std::string& lessons) {
    std::filesystem::create_directories(folder.path("text"));
    folder.write("text/" + language + ".json", R"({"format": "boxprobe-lesson-text", "version": 1, "language": ")" +
                                                   language + R"(", "chapters": {"c": "C"}, "lessons": {)" + lessons +
                                                   "}}");
  };
  const auto lesson = [](const std::string& name, const std::string& title) {
    return "\"" + name + R"(": {"title": ")" + title +
           R"(", "summary": "S", "steps": {"one": {"title": "t", "say": "s"}}})";
  };
  texts("en", lesson("first", "Good day") + ", " + lesson("second", "Farewell"));
  texts("eo", lesson("first", "Bonan tagon"));
  const auto list = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"lessons", "--folder", folder.path("")});
    const Outcome outcome = runProgram(more, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  };
  EXPECT_THAT(list({"--language", "en"}), AllOf(HasSubstr("Good day\n"), HasSubstr("Language: en (of en, eo)\n")));
  EXPECT_THAT(list({"--language", "eo"}), AllOf(HasSubstr("Bonan tagon\n"), HasSubstr("Farewell (en)\n")));
  const char* before = std::getenv("LC_ALL");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("LC_ALL", "eo_XX.UTF-8", 1);
  const json byLocale = json::parse(list({"--json"}));
  before != nullptr ? ::setenv("LC_ALL", kept.c_str(), 1) : ::unsetenv("LC_ALL");
  EXPECT_EQ(byLocale["language"], "eo");
  EXPECT_EQ(byLocale["lessons"][0]["language"], "eo");
  EXPECT_EQ(byLocale["lessons"][0]["title"], "Bonan tagon");
  EXPECT_EQ(byLocale["lessons"][1]["language"], "en");
}

}  // namespace
}  // namespace boxprobe::test
