// Every lesson held to what it says: each claim measured on the pictures it speaks of, each task tried with what solves
// it and what does not. One test a lesson.
#include <gtest/gtest.h>
#include <vtkOpenGLRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/lessons/lesson_player.h"
#include "filters/core/base/errors.h"
#include "filters/explain/schematic.h"
#include "filters/io/scene/lesson_file.h"

namespace {

using namespace boxprobe;

const LessonList& allLessons() {
  static const LessonList list = loadLessons(BOXPROBE_DATA_DIR "/lessons");
  return list;
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const Lesson& lesson : allLessons().lessons) result.push_back(lesson.name);
  return result;
}

LessonPlayer& player() {
  static LessonPlayer kept(320, 200);
  return kept;
}

class Claims : public testing::TestWithParam<std::string> {};

TEST_P(Claims, Hold) {
  const Lesson& lesson = findLesson(allLessons(), GetParam());
  EXPECT_FALSE(lesson.claims.empty()) << "a lesson that claims nothing teaches nothing";
  player().open(lesson);
  for (const LessonClaim& claim : lesson.claims) {
    const ClaimResult result = player().check(claim.condition);
    std::printf("  %s %.4g, limit %.4g\n", claim.say.c_str(), result.value, result.limit);
    EXPECT_TRUE(result.holds) << claim.say << ": " << result.value << " against " << result.limit;
  }
  for (const LessonExercise& exercise : lesson.exercises) {
    if (!exercise.condition) continue;
    const ClaimResult result = player().check(*exercise.condition);
    EXPECT_TRUE(result.holds) << exercise.ask << ": " << result.value << " against " << result.limit;
  }
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (!lesson.steps[i].task) continue;
    const LessonTask& task = *lesson.steps[i].task;
    double value = 0.0;
    player().show(i);
    EXPECT_FALSE(player().done(task, i, &value)) << task.ask << ": done before it is begun, at " << value;
    player().showChanged(i, task.mistake);
    EXPECT_FALSE(player().done(task, i, &value)) << task.ask << ": " << value;
    player().showChanged(i, task.solution);
    EXPECT_TRUE(player().done(task, i, &value)) << task.ask << ": " << value;
  }
}

// GoogleTest wants names of letters and digits.
INSTANTIATE_TEST_SUITE_P(Lessons, Claims, testing::ValuesIn(names()), [](const auto& parameter) {
  std::string name;
  for (const char c : parameter.param) name += c == '-' ? '_' : c;
  return name;
});

TEST(Lessons, AllCanBeRead) {
  for (const std::string& error : allLessons().errors) ADD_FAILURE() << error;
  EXPECT_GE(allLessons().lessons.size(), 22u);
}

// What a curve is drawn from is what the same measures give, value by value.
TEST(Lessons, ACurveIsMeasuredAtEachValue) {
  const Lesson& lesson = findLesson(allLessons(), "levels");
  const auto step =
      std::find_if(lesson.steps.begin(), lesson.steps.end(), [](const LessonStep& s) { return s.curve.has_value(); });
  ASSERT_NE(step, lesson.steps.end());
  player().open(lesson);
  const CurvePoints points = player().curve(static_cast<std::size_t>(step - lesson.steps.begin()));
  ASSERT_EQ(points.measured.size(), step->curve->values.size());
  EXPECT_TRUE(points.costs.empty());
  for (std::size_t i = 0; i < points.measured.size(); ++i) {
    const double alpha = step->curve->values[i] * step->curve->values[i];
    EXPECT_NEAR(points.measured[i], std::log2(1.0 + 63.0 * alpha), 0.01) << step->curve->values[i];
  }
}

// The fit's numbers are those of `boxprobe fit --json`; a name that it does not have is no number.
TEST(Lessons, AFitIsMeasured) {
  const Lesson& lesson = findLesson(allLessons(), "fit-by-program");
  player().open(lesson);
  LessonCondition condition;
  condition.measure.kind = MeasureKind::Fit;
  condition.measure.step = 0;
  condition.measure.name = "/probes/0/box/min/2";
  EXPECT_NEAR(player().check(condition).value, -3.0, 0.01);
  for (const char* name : {"/probes/1/box/min/2", "/probes/0/box/min/3", "/probes/0/faces/+w/gainDegrees", "/probes/0",
                           "", "/probes/x/box/min/0"}) {
    condition.measure.name = name;
    EXPECT_THROW(player().check(condition), WorkError) << name;
  }
}

// A ray to draw starts at the place of every inset, with a box round it.
TEST(Lessons, EveryInsetHasARay) {
  int insets = 0;
  const Lesson* open = nullptr;
  for (const Lesson& lesson : allLessons().lessons) {
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      if (!lesson.steps[i].inset) continue;
      const LessonInset& inset = *lesson.steps[i].inset;
      if (&lesson != open) player().open(lesson);
      open = &lesson;
      player().show(i);
      player().window()->MakeCurrent();
      const auto view = insetView(player().renderer().explain(static_cast<int>(inset.at[0] * 319),
                                                              static_cast<int>(inset.at[1] * 199), 320, 200),
                                  inset.elevation);
      ASSERT_TRUE(view) << lesson.name << ", step " << i + 1;
      EXPECT_TRUE(view->boxLow.has_value()) << lesson.name << ", step " << i + 1;
      ++insets;
    }
  }
  EXPECT_GE(insets, 20);
}

// The measuring can fail.
TEST(Lessons, ACheckThatDoesNotHoldSaysSo) {
  Lesson lesson = findLesson(allLessons(), "floor-mirror");
  ASSERT_FALSE(lesson.claims.empty());
  LessonCondition condition = lesson.claims.front().condition;
  condition.limit = 1.0e6;
  player().open(lesson);
  EXPECT_FALSE(player().check(condition).holds);
}

}  // namespace
