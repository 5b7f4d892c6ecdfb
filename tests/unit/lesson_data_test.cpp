// The program's own lessons: what a person reads stands in the file of texts and nowhere else, all of it is shown, and
// a second language takes its place lesson by lesson.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
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

bool isWord(const std::string& unit) {
  return unit.size() > 1 && unit != "\u00b0";
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
    if (step.curve) {
      for (const std::string& name :
           {step.curve->fieldName, step.curve->measureName, step.curve->costName, step.curve->lineName}) {
        add(name, !name.empty());
      }
    }
    if (!step.task) continue;
    add(step.task->ask);
    add(step.task->praise);
    add(step.task->unit, isWord(step.task->unit));
  }
  for (const LessonExercise& exercise : lesson.exercises) {
    add(exercise.ask);
    add(exercise.solution);
    add(exercise.formula, exercise.formula.find("\\text") != std::string::npos);
    add(exercise.unit, isWord(exercise.unit));
  }
  for (const LessonClaim& claim : lesson.claims) {
    add(claim.say);
    add(claim.unit, isWord(claim.unit));
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

TEST(LessonData, AThirdOfTheLessonsHasATask) {
  const LessonList list = loadLessons(kLessons);
  std::size_t tasks = 0;
  for (const Lesson& lesson : list.lessons) {
    tasks +=
        std::any_of(lesson.steps.begin(), lesson.steps.end(), [](const LessonStep& s) { return s.task.has_value(); })
            ? 1
            : 0;
  }
  EXPECT_GE(3 * tasks, list.lessons.size());
}

TEST(LessonData, AThirdOfTheLessonsHasAnExercise) {
  const LessonList list = loadLessons(kLessons);
  const auto with = std::count_if(list.lessons.begin(), list.lessons.end(),
                                  [](const Lesson& lesson) { return !lesson.exercises.empty(); });
  EXPECT_GE(3 * static_cast<std::size_t>(with), list.lessons.size());
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

/// Of a lesson's formula, without what is below and beside: "\\alpha", "P", but no index and no word.
std::vector<std::string> symbolsOf(const std::string& formula) {
  static const std::regex words(R"(\\text\{[^}]*\})"), below(R"(_(\{[^}]*\}|\\?[A-Za-z]+|[0-9]))"),
      symbol(R"(\\[A-Za-z]+|[A-Za-z])");
  const std::string bare = std::regex_replace(std::regex_replace(formula, words, " "), below, " ");
  std::vector<std::string> found;
  for (std::sregex_iterator it(bare.begin(), bare.end(), symbol), end; it != end; ++it) {
    static const std::vector<std::string> marks = {"\\cdot", "\\quad",  "\\frac", "\\sqrt", "\\sum", "\\pm",  "\\ge",
                                                   "\\le",   "\\infty", "\\min",  "\\max",  "\\mix", "\\sin", "\\cos"};
    if (std::find(marks.begin(), marks.end(), it->str()) == marks.end()) found.push_back(it->str());
  }
  return found;
}

// One meaning each, and none that no formula uses.
TEST(LessonData, TheNotationHasEverySymbolOnce) {
  const LessonList list = loadLessons(kLessons);
  std::map<std::string, std::string> known;
  std::map<std::string, int> used;
  for (const LessonSymbol& symbol : list.notation) {
    EXPECT_TRUE(known.emplace(symbol.symbol, symbol.means).second) << symbol.symbol << " stands there twice";
    used[symbol.symbol.substr(0, symbol.symbol.find('_'))];
  }
  EXPECT_GT(known.size(), 20u);
  for (const Lesson& lesson : list.lessons) {
    std::vector<std::string> formulas;
    for (const LessonStep& step : lesson.steps) formulas.push_back(step.formula);
    for (const LessonExercise& exercise : lesson.exercises) formulas.push_back(exercise.formula);
    for (const std::string& formula : formulas) {
      for (const std::string& symbol : symbolsOf(formula)) {
        ASSERT_EQ(used.count(symbol), 1u) << lesson.name << ": " << symbol << " in " << formula;
        ++used[symbol];
      }
    }
  }
  for (const auto& [symbol, times] : used) EXPECT_GT(times, 0) << symbol;
}

// Whoever always takes the longest answer, or the shortest, or the same letter, must not do better than by chance.
TEST(LessonData, TheRightAnswerIsNotTheLongest) {
  const LessonList list = loadLessons(kLessons);
  double questions = 0, chance = 0, longest = 0, shortest = 0;
  std::map<std::size_t, double> places;
  for (const Lesson& lesson : list.lessons) {
    for (const LessonStep& step : lesson.steps) {
      if (!step.question) continue;
      const auto& answers = step.question->answers;
      const auto right = std::find_if(answers.begin(), answers.end(), [](const LessonAnswer& a) { return a.right; });
      const auto shorter = [](const LessonAnswer& a, const LessonAnswer& b) { return a.text.size() < b.text.size(); };
      const auto [least, most] = std::minmax_element(answers.begin(), answers.end(), shorter);
      questions += 1;
      chance += 1.0 / static_cast<double>(answers.size());
      longest += right->text.size() == most->text.size() ? 1 : 0;
      shortest += right->text.size() == least->text.size() ? 1 : 0;
      places[static_cast<std::size_t>(right - answers.begin())] += 1;
    }
  }
  std::printf("  of %.0f questions the right answer is the longest in %.0f, the shortest in %.0f; by chance %.1f\n",
              questions, longest, shortest, chance);
  EXPECT_GT(questions, 30);
  EXPECT_LT(longest, 1.25 * chance);
  EXPECT_LT(shortest, 1.25 * chance);
  for (const auto& [place, times] : places) EXPECT_LT(times, 0.55 * questions) << "answer " << place + 1;
}

// A translation that nobody has read over says so in its own words, and every lesson shown in it carries them.
TEST(LessonData, AnUnreviewedTranslationSaysSo) {
  const LessonList list = loadLessons(kLessons, "zh-CN");
  EXPECT_THAT(list.errors, IsEmpty());
  EXPECT_THAT(list.textErrors, IsEmpty());
  EXPECT_EQ(list.notation.size(), loadLessons(kLessons).notation.size());
  for (std::size_t i = 0; i < list.lessons.size(); ++i) {
    const Lesson& lesson = list.lessons[i];
    EXPECT_EQ(lesson.unreviewed.empty(), lesson.language == "en") << lesson.name;
    // The first five are translated. A text that is missing would make the whole lesson English.
    EXPECT_EQ(lesson.language, i < 5 ? "zh-CN" : "en") << lesson.name;
  }
}

/// Every sentence a reader sees.
std::vector<std::string> sentencesOf(const Lesson& lesson) {
  std::vector<std::string> texts = {lesson.title, lesson.summary};
  for (const LessonStep& step : lesson.steps) {
    texts.insert(texts.end(), {step.title, step.say, step.mayMove});
    if (step.task) texts.insert(texts.end(), {step.task->ask, step.task->praise});
    if (step.curve) texts.insert(texts.end(), {step.curve->fieldName, step.curve->measureName});
    if (!step.question) continue;
    texts.push_back(step.question->ask);
    for (const LessonAnswer& answer : step.question->answers) texts.insert(texts.end(), {answer.text, answer.reply});
  }
  for (const LessonClaim& claim : lesson.claims) texts.push_back(claim.say);
  for (const LessonExercise& exercise : lesson.exercises) texts.insert(texts.end(), {exercise.ask, exercise.solution});
  return texts;
}

// What was copied from the English and never translated is found: it has no Chinese letter, or is what the English
// says.
TEST(LessonData, ATranslatedLessonIsTranslatedWhole) {
  const LessonList english = loadLessons(kLessons), list = loadLessons(kLessons, "zh-CN");
  ASSERT_EQ(english.lessons.size(), list.lessons.size());
  for (std::size_t i = 0; i < list.lessons.size(); ++i) {
    if (list.lessons[i].language == "en") continue;
    const std::vector<std::string> here = sentencesOf(list.lessons[i]), there = sentencesOf(english.lessons[i]);
    ASSERT_EQ(here.size(), there.size()) << list.lessons[i].name;
    for (std::size_t text = 0; text < here.size(); ++text) {
      if (there[text].empty()) continue;
      EXPECT_FALSE(here[text].empty()) << list.lessons[i].name << ": " << there[text];
      // Numbers alone are the same in both.
      if (there[text].find_first_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos) continue;
      EXPECT_NE(here[text], there[text]) << list.lessons[i].name;
      const bool chinese = std::any_of(here[text].begin(), here[text].end(),
                                       [](char c) { return (static_cast<unsigned char>(c) & 0xF0U) == 0xE0U; });
      EXPECT_TRUE(chinese) << list.lessons[i].name << ": " << here[text];
    }
  }
}

// Addresses that were given away go on: each of the 45 lessons of before is one of today's or begins within one.
TEST(LessonData, FormerLessonsAreFound) {
  const LessonList list = loadLessons(kLessons);
  std::size_t merged = 0;
  for (const char* name : {"black-mirror",
                           "painted-or-reflected",
                           "same-spheres",
                           "probe-per-sphere",
                           "one-or-nine",
                           "floor-mirror",
                           "three-distances",
                           "flat-box",
                           "far-away",
                           "divided-by-zero",
                           "in-the-cubemap",
                           "fit-the-box",
                           "fit-by-program",
                           "turned-room",
                           "off-the-box",
                           "impostor-marches",
                           "low-origin",
                           "sphere-proxy",
                           "planar-mirror",
                           "beyond-the-box",
                           "leaving-the-box",
                           "outside",
                           "bounces",
                           "fresnel",
                           "metal-or-not",
                           "dirty-mirror",
                           "no-sunlight-on-mirrors",
                           "bumpy-mirrors",
                           "levels",
                           "plain-means",
                           "swallowed-light",
                           "hdr",
                           "wrong-scale",
                           "contact-hardening",
                           "stretched-lamps",
                           "few-rays",
                           "seams",
                           "window-and-sky",
                           "soft-shadows",
                           "glass",
                           "eta",
                           "wrong-faces",
                           "half-the-size",
                           "bevel",
                           "box-occlusion"}) {
    const Lesson& lesson = findLesson(list, name);
    if (lesson.name == name) continue;
    ++merged;
    const auto step = formerStep(lesson, name);
    ASSERT_TRUE(step.has_value()) << name;
    EXPECT_EQ(&findLesson(list, lesson.name), &lesson);
  }
  EXPECT_EQ(merged, 28u);
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
    EXPECT_EQ(shown.chapter, usual.chapter.rfind("Part 1.", 0) == 0 ? "<" + usual.chapter + ">" : usual.chapter);
    EXPECT_EQ(shown.steps.size(), usual.steps.size());
    EXPECT_EQ(shown.steps[0].assignments, usual.steps[0].assignments);
  }
  EXPECT_EQ(translated, 2u);
  EXPECT_EQ(findLesson(list, "levels").language, "eo");
  EXPECT_EQ(findLesson(list, "floor-mirror").language, "eo");
}

}  // namespace
}  // namespace boxprobe
