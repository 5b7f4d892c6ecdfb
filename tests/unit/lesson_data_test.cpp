// The program's own lessons: what a person reads stands in the file of texts and nowhere else, all of it is shown, and
// a second language takes its place lesson by lesson.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>

#include "filters/io/files/read_file.h"
#include "filters/io/json/json_text.h"
#include "filters/io/scene/lesson_file.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::IsEmpty;

const std::string kLessons = BOXPROBE_DATA_DIR "/lessons";

Json jsonOf(const std::string& path) {
  return parseJsonText(readWholeFile(path, 1 << 22), path).root;
}

/// Each string, with the key it stands under.
void forEachText(Json& json, const std::string& key,
                 const std::function<void(std::string&, const std::string&)>& visit) {
  if (json.is_string()) visit(json.get_ref<std::string&>(), key);
  if (json.is_array()) {
    for (Json& element : json) forEachText(element, key, visit);
  }
  if (json.is_object()) {
    for (const auto& item : json.items()) forEachText(item.value(), item.key(), visit);
  }
}

/// What the lesson has a person read; formulas and units only where they hold words.
std::vector<std::string> textsOf(const Lesson& lesson) {
  std::vector<std::string> texts = {lesson.title, lesson.summary};
  const auto add = [&](const std::string& text, bool shown = true) {
    if (shown) texts.push_back(text);
  };
  for (const LessonStep& step : lesson.steps) {
    add(step.title);
    add(step.say);
    add(step.formula, step.formula.find("\\text") != std::string::npos);
    add(step.mayMove, !step.mayMove.empty());
    if (step.question) {
      add(step.question->ask);
      for (const LessonAnswer& answer : step.question->answers) {
        add(answer.text);
        add(answer.reply);
      }
    }
    if (!step.task) continue;
    add(step.task->ask);
    add(step.task->praise);
    add(step.task->unit, step.task->unit.size() > 1);
  }
  for (const LessonClaim& claim : lesson.claims) {
    add(claim.say);
    add(claim.unit, claim.unit.size() > 1);
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

std::vector<std::string> sortedTexts(Json& json) {
  std::vector<std::string> texts;
  forEachText(json, "", [&](const std::string& text, const std::string&) { texts.push_back(text); });
  std::sort(texts.begin(), texts.end());
  return texts;
}

bool isProse(const std::string& text) {
  static const std::regex twoWords("[A-Za-z]{2,}[^A-Za-z]*[ \t\n][^A-Za-z]*[A-Za-z]{2,}");
  return std::regex_search(text, twoWords);
}

TEST(LessonData, EveryTextIsShown) {
  Json english = jsonOf(kLessons + "/text/en.json");
  const LessonList list = loadLessons(kLessons);
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_THAT(list.textErrors, IsEmpty());
  EXPECT_EQ(english["lessons"].size(), list.lessons.size());
  std::vector<std::string> chapters;
  for (const Lesson& lesson : list.lessons) {
    EXPECT_EQ(textsOf(lesson), sortedTexts(english["lessons"][lesson.name])) << lesson.name;
    chapters.push_back(lesson.chapter);
  }
  std::sort(chapters.begin(), chapters.end());
  chapters.erase(std::unique(chapters.begin(), chapters.end()), chapters.end());
  EXPECT_EQ(chapters, sortedTexts(english["chapters"]));
}

TEST(LessonData, LessonFilesHoldNoProse) {
  EXPECT_TRUE(isProse("Two words."));
  EXPECT_FALSE(isProse("../scenes/room.boxprobe.json"));
  std::size_t texts = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kLessons)) {
    const std::string name = entry.path().filename().string();
    if (name.find(".lesson.json") == std::string::npos) continue;
    Json lesson = jsonOf(entry.path().string());
    forEachText(lesson, "", [&](const std::string& text, const std::string& key) {
      ++texts;
      if (key == "formula") {
        EXPECT_EQ(text.find("\\text"), std::string::npos) << name << ": words in a formula: " << text;
      } else if (key != "camera") {  // a name in the scene, or the lesson could not be read
        EXPECT_FALSE(isProse(text)) << name << ": " << key << ": " << text;
      }
    });
  }
  EXPECT_GT(texts, 37u);
}

class SecondLanguage : public TemporaryFolder {};

TEST_F(SecondLanguage, IsShownWhereItIsAndEnglishForTheRest) {
  const std::string lessons = file("lessons");
  std::filesystem::copy(kLessons, lessons, std::filesystem::copy_options::recursive);
  std::filesystem::create_directory_symlink(BOXPROBE_DATA_DIR "/scenes", file("scenes"));
  Json made = jsonOf(kLessons + "/text/en.json");
  const Json english = made;
  made["language"] = "eo";
  made["lessons"] = Json::object();
  const auto translate = [](Json& json) {
    forEachText(json, "", [](std::string& text, const std::string&) { text = "<" + text + ">"; });
  };
  for (const char* name : {"floor-mirror", "levels"}) {
    made["lessons"][name] = english["lessons"][name];
    translate(made["lessons"][name]);
  }
  translate(made["chapters"]["box-projection"]);
  for (const auto& item : english["chapters"].items()) {
    if (item.key() != "box-projection") made["chapters"].erase(item.key());
  }
  write("lessons/text/eo.json", made.dump(2));

  const LessonList list = loadLessons(lessons, "eo"), plain = loadLessons(lessons);
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_THAT(list.textErrors, IsEmpty());
  ASSERT_EQ(list.lessons.size(), plain.lessons.size());
  std::size_t translated = 0;
  for (std::size_t i = 0; i < list.lessons.size(); ++i) {
    const Lesson &shown = list.lessons[i], &usual = plain.lessons[i];
    EXPECT_EQ(shown.name, usual.name);
    std::vector<std::string> expected = textsOf(usual);
    if (shown.language == "eo") {
      ++translated;
      for (std::string& text : expected) text = "<" + text + ">";
      std::sort(expected.begin(), expected.end());
    }
    EXPECT_EQ(textsOf(shown), expected) << shown.name;
    EXPECT_EQ(shown.chapter, usual.chapter[0] == '2' ? "<" + usual.chapter + ">" : usual.chapter);
    EXPECT_EQ(shown.steps.size(), usual.steps.size());
    EXPECT_EQ(shown.steps[0].assignments, usual.steps[0].assignments);
  }
  EXPECT_EQ(translated, 2u);
  EXPECT_EQ(findLesson(list, "levels").language, "eo");
  EXPECT_EQ(findLesson(list, "floor-mirror").language, "eo");
}

}  // namespace
}  // namespace boxprobe
