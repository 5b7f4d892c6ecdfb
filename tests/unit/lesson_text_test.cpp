// Lessons' texts apart from the lessons: a second language, what is missing in it, and the one line for each way of
// getting a file of texts wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/lessons/lesson_language.h"
#include "filters/io/scene/lesson_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) {
    ADD_FAILURE() << "there is no " << what;
    return text;
  }
  return text.replace(at, what.size(), by);
}

class LessonText : public TemporaryFolder {
 protected:
  const std::string lesson_ = R"({"format": "boxprobe-lesson", "version": 1,
"chapter": "start", "scene": ")" BOXPROBE_DATA_DIR R"(/scenes/room.boxprobe.json",
"steps": [
{"id": "one", "formula": true, "mayMove": true, "question": {"answers": [{"id": "a"}, {"id": "b", "right": true}]}},
{"id": "two", "formula": "H = P", "task": {"measure": {"kind": "view", "name": "hit-error"}, "below": 1, "unit": "m",
  "solution": {}, "mistake": {}}}],
"claims": [{"id": "mean-1", "unit": true, "measure": {"kind": "mean", "step": 1}, "above": 0}]})";
  const std::string english_ = R"({"format": "boxprobe-lesson-text", "version": 1, "language": "en",
"chapters": {"start": "The start"},
"lessons": {"small": {"title": "Small", "summary": "All of it",
"steps": {
"one": {"title": "First", "say": "Look", "formula": "\\text{here}", "mayMove": "A ball",
  "question": {"ask": "Why?", "answers": {
    "a": {"text": "So", "reply": "No"},
    "b": {"text": "Because", "reply": "Yes"}}}},
"two": {"title": "Second", "say": "Do", "task": {"ask": "Push", "praise": "Well done"}}},
"claims": {"mean-1": {"say": "It is light", "unit": "grey"}}}}})";

  void SetUp() override {
    write("1-small.lesson.json", lesson_);
    write("text/en.json", english_);
  }
  Lesson small() const { return loadLessonFile(file("1-small.lesson.json")); }
  /// With one thing changed in the file of texts.
  std::string textError(const std::string& what, const std::string& by) const {
    const std::string path = write("text/en.json", replaced(english_, what, by));
    std::string line = errorText([&] { small(); });
    EXPECT_THAT(line, StartsWith(path + ":"));
    return line.substr(std::min(line.size(), path.size()));
  }
  std::string lessonError(const std::string& what, const std::string& by) const {
    const std::string path = write("1-small.lesson.json", replaced(lesson_, what, by));
    std::string line = errorText([&] { small(); });
    EXPECT_THAT(line, StartsWith(path + ":"));
    return line.substr(std::min(line.size(), path.size()));
  }
};

TEST_F(LessonText, ComesIntoTheLesson) {
  const Lesson lesson = small();
  EXPECT_EQ(lesson.language, "en");
  EXPECT_EQ(lesson.title, "Small");
  EXPECT_EQ(lesson.chapter, "The start");
  EXPECT_EQ(lesson.summary, "All of it");
  ASSERT_EQ(lesson.steps.size(), 2u);
  EXPECT_EQ(lesson.steps[0].say, "Look");
  EXPECT_EQ(lesson.steps[0].formula, "\\text{here}");
  EXPECT_EQ(lesson.steps[0].mayMove, "A ball");
  EXPECT_EQ(lesson.steps[0].question->ask, "Why?");
  EXPECT_EQ(lesson.steps[0].question->answers[1].text, "Because");
  EXPECT_EQ(lesson.steps[0].question->answers[1].reply, "Yes");
  EXPECT_TRUE(lesson.steps[0].question->answers[1].right);
  EXPECT_EQ(lesson.steps[1].title, "Second");
  EXPECT_EQ(lesson.steps[1].formula, "H = P");
  EXPECT_EQ(lesson.steps[1].task->praise, "Well done");
  EXPECT_EQ(lesson.steps[1].task->unit, "m");
  EXPECT_EQ(lesson.claims[0].say, "It is light");
  EXPECT_EQ(lesson.claims[0].unit, "grey");
}

TEST_F(LessonText, EachMistakeInTheTextsIsOneLineWithItsPlace) {
  EXPECT_THAT(textError("\"say\": \"Look\", ", ""),
              AllOf(StartsWith(":5:1: lessons.small.steps.one: "), HasSubstr("has no say; add \"say\": \"...\"")));
  EXPECT_THAT(textError("\"task\": {\"ask\": \"Push\", \"praise\": \"Well done\"}", "\"mayMove\": \"All\""),
              AllOf(StartsWith(":9:"), HasSubstr("lessons.small.steps.two.mayMove"), HasSubstr("no place")));
  EXPECT_THAT(textError(",\n    \"b\": {\"text\": \"Because\", \"reply\": \"Yes\"}", ""),
              AllOf(HasSubstr("steps.one.question.answers: "), HasSubstr("has no b")));
  EXPECT_THAT(textError("\"praise\"", "\"prase\""), AllOf(StartsWith(":9:"), HasSubstr("did you mean \"praise\"?")));
  EXPECT_THAT(textError("\"two\":", "\"three\":"),
              AllOf(StartsWith(":9:1: lessons.small.steps.three"), HasSubstr("two")));
  EXPECT_THAT(textError("\"Push\"", "\"\""), HasSubstr("steps.two.task.ask: is empty"));
  EXPECT_THAT(textError("\"Push\"", "7"), HasSubstr("steps.two.task.ask: must be text in quotes, not 7"));
  EXPECT_THAT(textError("{\"ask\": \"Push\", \"praise\": \"Well done\"}", "\"Push\""), HasSubstr("must be an object"));
  EXPECT_THAT(textError("\"small\"", "\"large\""), AllOf(HasSubstr("lessons: has no small; add \"small\"")));
  EXPECT_THAT(textError("\"start\"", "\"end\""), HasSubstr("chapters: has no start; add \"start\""));
  EXPECT_THAT(textError("boxprobe-lesson-text", "boxprobe-lesson"), HasSubstr("it starts with"));
  EXPECT_THAT(textError("\"version\": 1", "\"version\": 2"), HasSubstr("version: is not 1"));
  EXPECT_THAT(textError("\"language\": \"en\"", "\"language\": \"fr\""), HasSubstr("language: is \"fr\""));
  EXPECT_THAT(textError("\"chapters\"", "\"chapter\""), HasSubstr("has no chapters"));
  EXPECT_THAT(textError("\"chapters\"", "\"author\": \"me\", \"chapters\""), HasSubstr("author: unknown key"));
  EXPECT_THAT(textError("{\"format\"", "\"format\""), HasSubstr("not valid JSON"));
}

TEST_F(LessonText, EachMistakeInTheLessonIsOneLineWithItsPlace) {
  EXPECT_THAT(lessonError("\"id\": \"one\", ", ""), AllOf(StartsWith(":4:1: steps[0]"), HasSubstr("has no id")));
  EXPECT_THAT(lessonError("\"id\": \"two\"", "\"id\": \"one\""), AllOf(StartsWith(":5:"), HasSubstr("has this id")));
  EXPECT_THAT(lessonError("\"id\": \"two\"", "\"id\": \"Step two\""), HasSubstr("small letters"));
  EXPECT_THAT(lessonError("\"id\": \"two\"", "\"id\": \"two\", \"say\": \"s\""), HasSubstr("move it to"));
  EXPECT_THAT(lessonError("\"mayMove\": true", "\"mayMove\": \"All\""), HasSubstr("mayMove: must be true"));
  EXPECT_THAT(lessonError("\"chapter\": \"start\", ", ""), HasSubstr("has no chapter"));
  EXPECT_THAT(lessonError("\"chapter\"", "\"language\": \"en\", \"chapter\""), HasSubstr("language: "));
  EXPECT_THAT(lessonError("\"kind\": \"mean\"", "\"kind\": \"meen\""), AllOf(StartsWith(":7:"), HasSubstr("meen")));
  std::filesystem::remove(file("text/en.json"));
  EXPECT_THAT(lessonError("\"start\"", "\"start\""), AllOf(HasSubstr("has no title"), HasSubstr("text/en.json")));
}

TEST_F(LessonText, ALanguageFallsBackToEnglishLessonByLesson) {
  write("2-other.lesson.json", lesson_);
  const std::string small = english_.substr(english_.find("{\"title\": \"Small\""));
  const std::string both =
      replaced(english_, "\"small\": ", "\"other\": " + small.substr(0, small.size() - 2) + ",\n\"small\": ");
  write("text/en.json", both);
  std::string german = replaced(english_, "\"en\"", "\"de\"");
  write("text/de.json", replaced(german, "\"Small\"", "\"Klein\""));
  LessonList list = loadLessons(folder_.string(), "de");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_THAT(list.textErrors, IsEmpty()) << "what is not translated yet is no mistake";
  ASSERT_EQ(list.lessons.size(), 2u);
  EXPECT_EQ(list.language, "de");
  EXPECT_EQ(list.lessons[0].language, "de");
  EXPECT_EQ(list.lessons[0].title, "Klein");
  EXPECT_EQ(list.lessons[1].language, "en");
  EXPECT_EQ(list.lessons[1].title, "Small");

  german = replaced(replaced(german, "\"Small\"", "\"Klein\""), "\"praise\": \"Well done\"", "\"prise\": \"Gut\"");
  const std::string path = write("text/de.json", replaced(german, "\"start\": \"The start\"", ""));
  list = loadLessons(folder_.string(), "de");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_EQ(list.lessons[0].language, "en");
  EXPECT_EQ(list.lessons[0].title, "Small");
  EXPECT_EQ(list.lessons[0].chapter, "The start");
  EXPECT_THAT(list.textErrors, ElementsAre(AllOf(StartsWith(path + ":9:"), HasSubstr("small.steps.two.task.prise"),
                                                 HasSubstr("the lesson is in English until then"))));
  EXPECT_THAT(lessonLanguages(folder_.string()), ElementsAre("de", "en"));
}

TEST_F(LessonText, TextsThatNoLessonAsksForAreTold) {
  const std::string stray = replaced(english_, "\"small\": ", "\"smal\": {}, \"small\": ");
  const std::string path =
      write("text/en.json", replaced(stray, "\"The start\"", "\"The start\", \"end\": \"The end\""));
  const LessonList list = loadLessons(folder_.string());
  EXPECT_EQ(list.lessons.size(), 1u);
  EXPECT_THAT(list.textErrors,
              ElementsAre(AllOf(StartsWith(path + ":3:"), HasSubstr("lessons.smal: "), HasSubstr("\"small\"?")),
                          AllOf(StartsWith(path + ":2:"), HasSubstr("chapters.end: "), HasSubstr("take it out"))));
}

TEST_F(LessonText, AnUnknownLanguageIsRefused) {
  write("text/de.json", replaced(english_, "\"en\"", "\"de\""));
  EXPECT_THAT(errorText([&] { loadLessons(folder_.string(), "fr"); }),
              AllOf(StartsWith("language fr: "), HasSubstr("de, en")));
  EXPECT_THAT(errorText([&] { loadLessons(folder_.string(), "../text/de"); }), HasSubstr("no lesson is in it"));
  EXPECT_THAT(errorText([&] { loadLessons(folder_.string(), "DE"); }), HasSubstr("did you mean \"de\"?"));
  const std::string broken = write("text/de.json", english_);
  EXPECT_THAT(errorText([&] { loadLessons(folder_.string(), "de"); }), StartsWith(broken + ":1:"));
}

TEST_F(LessonText, ALessonMayCarryItsTextsAndNameTheirLanguage) {
  const std::string inOne = R"({"format": "boxprobe-lesson", "version": 1, LANGUAGE"title": "T", "chapter": "C",
    "summary": "S", "scene": ")" BOXPROBE_DATA_DIR
                            R"(/scenes/room.boxprobe.json", "steps": [{"id": "one", "title": "t", "say": "s"}]})";
  EXPECT_EQ(loadLessonFile(write("2-own.lesson.json", replaced(inOne, "LANGUAGE", ""))).language, "en");
  write("2-own.lesson.json", replaced(inOne, "LANGUAGE", "\"language\": \"fr\", "));
  const LessonList list = loadLessons(folder_.string(), "fr");
  EXPECT_THAT(list.textErrors, IsEmpty());
  ASSERT_EQ(list.lessons.size(), 2u);
  EXPECT_EQ(list.lessons[0].language, "en");
  EXPECT_EQ(list.lessons[1].language, "fr");
  EXPECT_EQ(list.lessons[1].title, "T");
  const std::string wrong = write("2-own.lesson.json", replaced(inOne, "LANGUAGE", "\"language\": \"le fr\", "));
  EXPECT_THAT(errorText([&] { loadLessonFile(wrong); }), HasSubstr("language: must be a language"));
}

TEST(LessonLanguage, IsThatOfTheLocaleIfItIsThere) {
  const std::vector<std::string> there = {"de", "en", "pt", "pt-BR"};
  EXPECT_EQ(languageOfLocale("de_AT.UTF-8", there), "de");
  EXPECT_EQ(languageOfLocale("pt_BR.UTF-8", there), "pt-BR");
  EXPECT_EQ(languageOfLocale("pt_PT@euro", there), "pt");
  for (const char* other : {"", "C", "C.UTF-8", "POSIX", "fr_FR.UTF-8", "_", "."}) {
    EXPECT_EQ(languageOfLocale(other, there), "en") << other;
  }
}

TEST(LessonLanguage, TheNarrowestVariableOfTheEnvironmentSaysTheLocale) {
  std::vector<std::pair<std::string, std::string>> before;
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    if (const char* value = std::getenv(name)) before.emplace_back(name, value);
    ::unsetenv(name);
  }
  EXPECT_EQ(messageLocale(), "");
  ::setenv("LANG", "de", 1);
  EXPECT_EQ(messageLocale(), "de");
  ::setenv("LC_MESSAGES", "fr", 1);
  EXPECT_EQ(messageLocale(), "fr");
  ::setenv("LC_ALL", "", 1);
  EXPECT_EQ(messageLocale(), "fr");
  ::setenv("LC_ALL", "pt", 1);
  EXPECT_EQ(messageLocale(), "pt");
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) ::unsetenv(name);
  for (const auto& [name, value] : before) ::setenv(name.c_str(), value.c_str(), 1);
}

TEST_F(LessonText, HasTheNotationAndSaysThatNobodyHasReadItOver) {
  const std::string head = "\"language\": \"en\",";
  const auto with = [&](const std::string& more) {
    write("text/en.json", replaced(english_, head, head + " " + more));
    return loadLessons(file(""));
  };
  const LessonList list = with(R"("unreviewed": "not read over", "notation": [{"symbol": "t_i", "means": "a way"}],)");
  ASSERT_EQ(list.notation.size(), 1u);
  EXPECT_EQ(list.notation[0].symbol, "t_i");
  EXPECT_EQ(list.notation[0].means, "a way");
  EXPECT_EQ(list.lessons.at(0).unreviewed, "not read over");
  EXPECT_THAT(with("").notation, IsEmpty());
  EXPECT_EQ(with("").lessons.at(0).unreviewed, "");
  EXPECT_THAT(errorText([&] { with(R"("unreviewed": "",)"); }), AllOf(HasSubstr("en.json:"), HasSubstr("is empty")));
  EXPECT_THAT(errorText([&] { with(R"("notation": [{"symbol": "P"}],)"); }),
              AllOf(HasSubstr("notation[0]"), HasSubstr("needs both")));
  EXPECT_THAT(errorText([&] { with(R"("notation": [{"symbol": "P", "meaning": "a"}],)"); }), HasSubstr("meaning"));
}

}  // namespace
}  // namespace boxprobe
