// Lesson files: what is read, and the one line for each way of getting it wrong.
#include "filters/io/scene/lesson_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/lessons/formula_mathml.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class LessonFile : public TemporaryFolder {
 protected:
  /// A lesson over data/scenes/room with one step; `step` are further members of it, `lesson` of the lesson.
  std::string lesson(const std::string& step, const std::string& lesson = "") const {
    return "{\n\"format\": \"boxprobe-lesson\", \"version\": 1, \"title\": \"T\", \"chapter\": \"C\", \"summary\": "
           "\"S\",\n"
           "\"scene\": \"" BOXPROBE_DATA_DIR
           "/scenes/room.boxprobe.json\",\n\"steps\": [{\"title\": \"t\", \"say\": \"s\"" +
           (step.empty() ? "" : ",\n" + step) + "}]" + (lesson.empty() ? "" : ",\n" + lesson) + "}\n";
  }
  std::string error(const std::string& text) const {
    const std::string path = write("1-wrong.lesson.json", text);
    std::string line = errorText([&] { loadLessonFile(path); });
    EXPECT_THAT(line, StartsWith(path));
    return line.substr(std::min(line.size(), path.size()));
  }
};

TEST_F(LessonFile, IsReadWithDefaultsAndNamedByItsFile) {
  const Lesson read = loadLessonFile(write("07-a-name.lesson.json", lesson("\"camera\": \"A\"")));
  EXPECT_EQ(read.name, "a-name");
  ASSERT_EQ(read.steps.size(), 1u);
  EXPECT_TRUE(read.steps[0].reflections);
  const Scene scene = lessonScene(read, 0);
  EXPECT_EQ(lessonCamera(read, 0, scene).verticalFovDegrees, 45.0);
}

TEST_F(LessonFile, StepsBuildOnThoseBefore) {
  const std::string two = lesson(
      "\"set\": {\"exposure\": 2}},\n{\"title\": \"u\", \"say\": \"s\", \"set\": "
      "{\"probes.room.bounces\": 3}");
  const Lesson read = loadLessonFile(write("1-two.lesson.json", two));
  EXPECT_EQ(lessonScene(read, 0).probes[0].bounces, 2);
  EXPECT_EQ(lessonScene(read, 1).probes[0].bounces, 3);
  EXPECT_EQ(lessonScene(read, 1).exposure, 2.0);
}

TEST_F(LessonFile, EachMistakeIsOneLineWithItsPlace) {
  EXPECT_THAT(error("{"), HasSubstr(":"));
  EXPECT_THAT(error("{\"format\": \"boxprobe-scene\"}"), HasSubstr("is not a lesson"));
  EXPECT_THAT(error(lesson("\"vieuw\": \"level\"")), HasSubstr(":5:"));
  EXPECT_THAT(error(lesson("\"view\": \"levle\"")), HasSubstr("level"));
  EXPECT_THAT(error(lesson("\"camera\": \"nowhere\"")), HasSubstr("no such camera"));
  EXPECT_THAT(error(lesson("\"set\": {\"probes.hall.technique\": \"box\"}")), HasSubstr("hall"));
  EXPECT_THAT(error(lesson("\"set\": {\"probes.room.technique\": \"boxx\"}")), HasSubstr("boxx"));
  EXPECT_THAT(error(lesson("\"rays\": [[0.5, 1.5]]")), HasSubstr("from 0 to 1"));
  EXPECT_THAT(error(lesson("\"published\": \"mine\"")), HasSubstr("published"));
  EXPECT_THAT(error(lesson("\"question\": {\"ask\": \"?\", \"answers\": [{\"text\": \"a\", \"reply\": \"b\"}]}")),
              HasSubstr("needs two or more"));
  EXPECT_THAT(error(lesson("", "\"claims\": [{\"say\": \"s\", \"measure\": {\"kind\": \"mean\"}, \"above\": 1}]")),
              HasSubstr("step"));
  EXPECT_THAT(
      error(lesson("", "\"claims\": [{\"say\": \"s\", \"measure\": {\"kind\": \"mean\", \"step\": 2}, \"above\": 1}]")),
      HasSubstr("counted from 1 to 1"));
  EXPECT_THAT(error(lesson("", "\"claims\": [{\"say\": \"s\", \"measure\": {\"kind\": \"mean\", \"step\": 1}}]")),
              HasSubstr("above, below and equals"));
  EXPECT_THAT(error(lesson("", "\"exercises\": [{\"ask\": \"a\"}]")), HasSubstr("solution"));
  EXPECT_THAT(error(lesson("", "\"exercises\": [{\"ask\": \"a\", \"solution\": \"s\", \"above\": 1}]")),
              HasSubstr("belongs to a measure"));
  EXPECT_THAT(error(lesson("",
                           "\"exercises\": [{\"ask\": \"a\", \"solution\": \"s\", \"measure\": {\"kind\": \"mean\"}, "
                           "\"above\": 1}]")),
              HasSubstr("\"step\": 1"));
  const auto curve = [&](const std::string& field, const std::string& values) {
    return error(lesson("\"curve\": {\"field\": \"" + field + "\", \"values\": " + values +
                        ", \"fieldName\": \"f\", \"measure\": {\"kind\": \"mean\"}, \"measureName\": \"m\"}"));
  };
  EXPECT_THAT(curve("exposure", "[2, 1]"), HasSubstr("larger than the one before"));
  EXPECT_THAT(curve("exposure", "[1]"), HasSubstr("needs 2 to 32 numbers"));
  EXPECT_THAT(curve("exposhure", "[1, 2]"), HasSubstr("exposure"));
  EXPECT_THAT(curve("exposure", "[-1, 2]"), HasSubstr("curve"));
  EXPECT_THAT(error(lesson("\"map\": {}")), HasSubstr("one of levels and lookups"));
  EXPECT_THAT(error(lesson("\"map\": {\"levels\": [0], \"lookups\": [0, 0, 1, 1]}")), HasSubstr("one of levels"));
  EXPECT_THAT(error(lesson("\"map\": {\"levels\": [-1]}")), HasSubstr("is a mip level"));
  EXPECT_THAT(error(lesson("\"map\": {\"levels\": []}")), HasSubstr("needs 1 to 7 levels"));
  EXPECT_THAT(error(lesson("\"map\": {\"levels\": [0], \"face\": \"x\"}")), HasSubstr("face"));
  EXPECT_THAT(error(lesson("\"map\": {\"lookups\": [0, 0.5, 1, 0.5]}")), HasSubstr("is empty"));
  EXPECT_THAT(error(lesson("\"map\": {\"lookups\": [0, 0, 1, 1], \"face\": \"+x\"}")), HasSubstr("belongs to levels"));
  EXPECT_THAT(error(lesson("\"inset\": {}")), HasSubstr("one of plan and elevation"));
  EXPECT_THAT(error(lesson("\"inset\": {\"plan\": [0, 0], \"elevation\": [0, 0]}")), HasSubstr("one of plan and"));
  EXPECT_THAT(error(lesson("\"inset\": {\"plan\": [0.5, 1.5]}")), HasSubstr("from 0 to 1"));
  EXPECT_THAT(error(lesson("\"inset\": {\"plan\": [0, 0], \"corner\": \"middle\"}")), HasSubstr("bottom-left"));
  EXPECT_THAT(error(lesson("\"inset\": {\"plan\": [0, 0]}, \"published\": \"half\"")), HasSubstr("published form"));
  EXPECT_THAT(error(lesson("\"inset\": {\"plan\": [0, 0]}, \"map\": {\"levels\": [0]}")), HasSubstr("no view of"));
  std::string missing = lesson("");
  missing.replace(missing.find("room.boxprobe"), 4, "cellar");
  EXPECT_THAT(error(missing), HasSubstr("cellar"));
}

TEST_F(LessonFile, AStepMayStartAnew) {
  const std::string scenes = BOXPROBE_DATA_DIR "/scenes/";
  const auto text = [&](const std::string& other) {
    return R"({"format": "boxprobe-lesson", "version": 1, "title": "t", "chapter": "c", "summary": "s", "scene": ")" +
           scenes + R"(room.boxprobe.json", "set": {"exposure": 3}, "steps": [
      {"title": "a", "say": "s", "camera": "C", "set": {"probes.room.intensity": 2}},
      {"title": "b", "say": "s", "scene": ")" +
           scenes + other + R"(", "formerly": "older", "set": {"exposure": 5}},
      {"title": "c", "say": "s"}]})";
  };
  const Lesson read = loadLessonFile(write("1-two.lesson.json", text("building.boxprobe.json")));
  EXPECT_EQ(lessonScene(read, 0).probes[0].intensity, 2.0);
  EXPECT_EQ(lessonScene(read, 0).exposure, 3.0);
  EXPECT_EQ(sceneFileOf(read, 0), scenes + "room.boxprobe.json");
  for (const std::size_t step : {1u, 2u}) {
    const Scene scene = lessonScene(read, step);
    EXPECT_EQ(sceneFileOf(read, step), scenes + "building.boxprobe.json");
    EXPECT_EQ(scene.exposure, 5.0) << "the lesson's own changes are of its own scene";
    EXPECT_EQ(lessonCamera(read, step, scene).name, "main") << "a camera of the scene before is not kept";
  }
  EXPECT_EQ(formerStep(read, "older"), std::optional<std::size_t>(1));
  EXPECT_FALSE(formerStep(read, "two").has_value());
  EXPECT_FALSE(formerStep(read, "").has_value());
  EXPECT_EQ(lessonScene(loadLessonFile(write("2-same.lesson.json", text("room.boxprobe.json"))), 2).probes[0].intensity,
            1.0)
      << "the same scene file, too, is read anew";
  EXPECT_EQ(findLesson(loadLessons(folder_.string()), "older").name, "two");
  EXPECT_THAT(error(text("cellar.boxprobe.json")), AllOf(HasSubstr("steps[1].scene"), HasSubstr("cellar")));
}

TEST_F(LessonFile, MapsAreReadWhole) {
  const Lesson levels = loadLessonFile(write(
      "1-levels.lesson.json", lesson("\"map\": {\"levels\": [0, 3], \"face\": \"-y\"}, \"published\": \"fixup\"")));
  ASSERT_TRUE(levels.steps[0].map.has_value());
  EXPECT_EQ(levels.steps[0].map->levels, (std::vector<int>{0, 3}));
  EXPECT_EQ(levels.steps[0].map->face, 3);
  EXPECT_FALSE(levels.steps[0].map->lookups.has_value());
  EXPECT_TRUE(levels.steps[0].drawn());
  EXPECT_EQ(levels.steps[0].published, "fixup");
  const Lesson lookups =
      loadLessonFile(write("2-lookups.lesson.json", lesson("\"map\": {\"lookups\": [0, 0.5, 1, 0.75]}")));
  EXPECT_EQ(lookups.steps[0].map->lookups, (PictureRegion{0, 0.5, 1, 0.75}));
}

TEST_F(LessonFile, InsetsAreReadWhole) {
  const Lesson plan = loadLessonFile(write("1-plan.lesson.json", lesson("\"inset\": {\"plan\": [0.25, 0.75]}")));
  ASSERT_TRUE(plan.steps[0].inset.has_value());
  EXPECT_EQ(plan.steps[0].inset->at, (PicturePoint{0.25, 0.75}));
  EXPECT_FALSE(plan.steps[0].inset->elevation);
  EXPECT_TRUE(plan.steps[0].inset->right && plan.steps[0].inset->bottom);
  const Lesson side = loadLessonFile(
      write("2-side.lesson.json", lesson("\"inset\": {\"elevation\": [0, 1], \"corner\": \"bottom-left\"}")));
  EXPECT_TRUE(side.steps[0].inset->elevation);
  EXPECT_FALSE(side.steps[0].inset->right);
  EXPECT_TRUE(side.steps[0].inset->bottom);
}

TEST_F(LessonFile, ExercisesAndCurvesAreReadWhole) {
  const Lesson read = loadLessonFile(write(
      "1-paper.lesson.json",
      lesson("\"curve\": {\"field\": \"exposure\", \"values\": [0.5, 1, 2], \"fieldName\": \"f\", \"measure\": "
             "{\"kind\": \"mean\"}, \"measureName\": \"m\", \"line\": {\"kind\": \"mean\", \"step\": 1}, "
             "\"lineName\": \"l\"}",
             "\"exercises\": [{\"ask\": \"a\", \"solution\": \"s\", \"formula\": \"P\", \"unit\": \"m\", \"measure\": "
             "{\"kind\": \"fit\", \"step\": 1, \"name\": \"/probes/0/box/max/2\"}, \"equals\": 3, \"within\": 0.1}]")));
  ASSERT_TRUE(read.steps[0].curve.has_value());
  EXPECT_EQ(read.steps[0].curve->values, (std::vector<double>{0.5, 1, 2}));
  EXPECT_FALSE(read.steps[0].curve->cost.has_value());
  EXPECT_TRUE(read.steps[0].curve->line.has_value());
  ASSERT_EQ(read.exercises.size(), 1u);
  EXPECT_EQ(read.exercises[0].formula, "P");
  EXPECT_EQ(read.exercises[0].condition->measure.kind, MeasureKind::Fit);
  EXPECT_EQ(read.exercises[0].condition->comparison, Comparison::Within);
}

TEST_F(LessonFile, TheOthersStillList) {
  write("1-good.lesson.json", lesson(""));
  write("2-bad.lesson.json", "{");
  write("3-also-good.lesson.json", lesson(""));
  write("notes.txt", "no lesson");
  const LessonList list = loadLessons(folder_.string());
  ASSERT_EQ(list.lessons.size(), 2u);
  EXPECT_EQ(list.lessons[1].name, "also-good");
  ASSERT_EQ(list.errors.size(), 1u);
  EXPECT_THAT(list.errors[0], HasSubstr("2-bad.lesson.json"));
  EXPECT_THAT(errorText([&] { findLesson(list, "goood"); }), HasSubstr("good"));
}

TEST_F(LessonFile, AFolderWithoutLessonsIsRefused) {
  EXPECT_THAT(errorText([&] { loadLessons(folder_.string()); }), HasSubstr("no lesson"));
  EXPECT_THAT(errorText([&] { loadLessons(file("none")); }), HasSubstr("no such folder"));
}

TEST(FormulaMathml, SetsWhatLessonsWrite) {
  EXPECT_EQ(formulaMathml("H = P"), "<mrow><mi>H</mi><mo>=</mo><mi>P</mi></mrow>");
  EXPECT_EQ(formulaMathml("t_i"), "<mrow><msub><mi>t</mi><mi>i</mi></msub></mrow>");
  EXPECT_EQ(formulaMathml("p^{2x}"), "<mrow><msup><mi>p</mi><mrow><mn>2</mn><mi>x</mi></mrow></msup></mrow>");
  EXPECT_EQ(formulaMathml("\\min_i t"),
            "<mrow><munder><mi mathvariant=\"normal\">min</mi><mi>i</mi></munder><mi>t</mi></mrow>");
  EXPECT_EQ(formulaMathml("\\frac{1}{\\pi}"),
            "<mrow><mfrac><mrow><mn>1</mn></mrow><mrow><mi>\u03c0</mi></mrow></mfrac></mrow>");
  EXPECT_EQ(formulaMathml("a < b"), "<mrow><mi>a</mi><mo>&lt;</mo><mi>b</mi></mrow>");
}

TEST(FormulaMathml, IsTotal) {
  for (const char* text :
       {"", "_", "^", "a_", "{", "}", "\\frac", "\\frac{1", "\\text{open", "\\unknown", "\\", "\xc3"}) {
    EXPECT_THAT(formulaMathml(text), StartsWith("<mrow>")) << text;
  }
  EXPECT_THAT(formulaMathml(std::string(100000, '{')), StartsWith("<mrow>"));
}

}  // namespace
}  // namespace boxprobe
