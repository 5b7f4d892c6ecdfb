// The page's own words in another language: none is missing, none is left over, and what stands for values is kept. The
// texts are found in the sources, so one that is new there is missed here.
#include "app/lessons/page_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "app/lessons/page_sketches.h"
#include "app/lessons/page_widgets.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/read_file.h"
#include "filters/io/scene/lesson_file.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;

const std::string kData = BOXPROBE_DATA_DIR, kPageLessons = kData + "/lessons";

/// The literals that `call` is given, adjoining ones as one; `quote` is " or '.
void addLiterals(const std::string& source, const std::string& call, char quote, std::set<std::string>& found) {
  const std::string q(1, quote), literal = q + "((?:[^" + q + "\\\\]|\\\\.)*)" + q;
  const std::regex pattern("\\b" + call + "\\(\\s*((?:" + literal + "\\s*)+)"), one(literal);
  for (std::sregex_iterator it(source.begin(), source.end(), pattern), end; it != end; ++it) {
    const std::string all = (*it)[1];
    std::string text;
    for (std::sregex_iterator part(all.begin(), all.end(), one); part != end; ++part) text += (*part)[1];
    found.insert(text);
  }
}

/// Everything that a page says by itself whose first lessons, and no others, are in this language.
std::set<std::string> wordsOf(const std::set<std::string>& lessons) {
  const auto translated = [&](const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return lessons.count(name) > 0; });
  };
  const PageWidgets widgets = loadPageWidgets(kPageLessons);
  std::set<std::string> found;
  std::string figures;  // that have a script of their own
  for (const PageSketch& sketch : pageSketches()) {
    const auto of = widgets.figures.find(sketch.name);
    if (of == widgets.figures.end() || !translated(of->second)) continue;
    found.insert({sketch.title, sketch.say});
    figures += std::string(" ") + sketch.name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(kData + "/web")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".js" || name == "sketches_more.js") continue;
    addLiterals(readWholeFile(entry.path().string()), "say", '\'', found);
  }
  EXPECT_EQ(figures, " ball impostor") << "sketches_more.js holds what has no translation";
  const std::string page = readWholeFile(BOXPROBE_SOURCE_DIR "/app/gui/lessons/lesson_page.cpp");
  for (const char* call : {"say", "say_", "atTheEnd"}) addLiterals(page, call, '"', found);
  for (const auto& [lesson, code] : widgets.code) {
    if (lessons.count(lesson) > 0) found.insert(code.say);
  }
  for (const LessonLoop& loop : widgets.loops) {
    if (lessons.count(loop.lesson) > 0) found.insert(loop.say);
  }
  return found;
}

TEST(PageTexts, NoneIsMissingAndNoneLeftOver) {
  std::set<std::string> lessons;
  for (const Lesson& lesson : loadLessons(kPageLessons, "zh-CN").lessons) {
    if (lesson.language == "zh-CN") lessons.insert(lesson.name);
  }
  const PageTexts say(kPageLessons, "zh-CN");
  EXPECT_EQ(say.language(), "zh-CN");
  EXPECT_FALSE(say.unreviewed().empty());
  const std::set<std::string> words = wordsOf(lessons);
  EXPECT_GT(words.size(), 130u);
  for (const std::string& english : words) EXPECT_EQ(say.all().count(english), 1u) << "missing: " << english;
  const std::regex value("\\{[0-9]\\}"), chinese("[\xe3-\xe9][\x80-\xbf][\x80-\xbf]");
  const auto valuesIn = [&](const std::string& text) {
    return std::multiset<std::string>(std::sregex_token_iterator(text.begin(), text.end(), value),
                                      std::sregex_token_iterator());
  };
  for (const auto& [english, text] : say.all()) {
    EXPECT_TRUE(words.count(english) > 0) << "left over: " << english;
    EXPECT_EQ(valuesIn(english), valuesIn(text)) << english;
    EXPECT_TRUE(std::regex_search(text, chinese)) << "not translated: " << text;
  }
}

class PageTextFiles : public TemporaryFolder {};

TEST_F(PageTextFiles, ValuesAreFilledInAndTheRestIsEnglish) {
  write("page/xx.json", R"({"format": "boxprobe-lesson-page-text", "version": 1, "language": "xx",
    "texts": {"{0} of {1}": "{1}: {0}"}})");
  const PageTexts say(file("."), "xx");
  EXPECT_EQ(say("{0} of {1}", {"two", "five"}), "five: two");
  EXPECT_EQ(say("{0} more", {"six"}), "six more");
  EXPECT_EQ(PageTexts(file("."), "yy").language(), "en");
}

TEST_F(PageTextFiles, BadFilesAreOneLine) {
  for (const char* text : {"[", R"({"format": "other"})",
                           R"({"format": "boxprobe-lesson-page-text", "version": 1, "language": "de", "texts": {}})",
                           R"({"format": "boxprobe-lesson-page-text", "version": 1, "language": "xx",
                               "texts": {"a": 1}})"}) {
    write("page/xx.json", text);
    try {
      PageTexts(file("."), "xx");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("xx.json"));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace boxprobe
