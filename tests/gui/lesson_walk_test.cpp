// Every lesson, from the list to its end, by keys and buttons: each step shows what its file says, each question is
// answered wrong and then right, each task is undone by its mistake and done by its answer.
#include <gtest/gtest.h>

#include <QAction>
#include <QTest>

#include "app/gui/explain/debug_view.h"
#include "app/gui/explain/surface_view_panel.h"
#include "app/gui/lessons/lesson_progress.h"
#include "tests/gui/lesson_steps.h"

namespace boxprobe {
namespace {

std::vector<std::string> lessonNames() {
  std::vector<std::string> names;
  for (const Lesson& lesson : loadLessons(lessonFolder()).lessons) names.push_back(lesson.name);
  return names;
}

class LessonWalkTest : public LessonWindowTest, public ::testing::WithParamInterface<std::string> {
 protected:
  LessonProgress progress() const { return lessonProgress(QString::fromStdString(GetParam())); }

  void expectStep(const Lesson& lesson, std::size_t index) {
    ASSERT_NE(visit().lesson(), nullptr);
    ASSERT_EQ(visit().step(), index);
    const LessonStep& step = lesson.steps[index];
    EXPECT_EQ(text("stepTitle").toStdString(), step.title);
    EXPECT_EQ(text("stepText").toStdString(), step.say);
    EXPECT_EQ(shown("stepFormula"), !step.formula.empty());
    EXPECT_EQ(shown("stepTry"), !step.mayMove.empty() || step.drawn());
    EXPECT_EQ(shown("lessonQuestion"), step.question.has_value());
    EXPECT_EQ(shown("lessonTask"), step.task.has_value());
    EXPECT_EQ(document().scene(), lessonScene(lesson, index));
    EXPECT_EQ(window_->debugView().surfacePanel()->settings().view, findSurfaceView(step.view).value_or(0));
    EXPECT_EQ(window_->findChild<QAction*>("showBoxes")->isChecked(), step.boxes);
    EXPECT_EQ(window_->findChild<QAction*>("showReflections")->isChecked(), step.reflections);
    if (!step.published.empty()) {
      waitUntilIdle();
      ASSERT_TRUE(QTest::qWaitFor([this] { return lessons().published().complete(); }, 60000));
      EXPECT_TRUE(shown("publishedPicture"));
      keepPicture("lesson_published_" + QString::fromStdString(step.published));
    } else {
      EXPECT_FALSE(shown("publishedPicture"));
    }
    if (step.rays.empty()) return;
    waitUntilIdle();
    EXPECT_GT(window_->debugView().rays().rays(), 0) << "no ray starts where the step says";
  }

  void answer(const LessonQuestion& question, std::size_t step) {
    const auto press = [&](std::size_t i) {
      click(QString("answer%1").arg(i));
      EXPECT_TRUE(text("reply").contains(QString::fromStdString(question.answers[i].reply)))
          << text("reply").toStdString();
    };
    std::size_t right = question.answers.size();
    for (std::size_t i = 0; i < question.answers.size(); ++i) {
      if (question.answers[i].right) {
        right = i;
        continue;
      }
      press(i);
      EXPECT_TRUE(text("reply").startsWith("Not this one."));
      EXPECT_FALSE(progress().solved.contains(solvedQuestion(step))) << question.answers[i].text;
    }
    ASSERT_LT(right, question.answers.size());
    press(right);
    EXPECT_TRUE(progress().solved.contains(solvedQuestion(step)));
  }

  void perform(const LessonTask& task, std::size_t step) {
    const auto expectDone = [&](bool done) {
      waitForMeasure();
      ASSERT_TRUE(lessons().check().result().has_value()) << text("taskValue").toStdString();
      EXPECT_EQ(lessons().check().result()->done, done) << text("taskValue").toStdString();
      EXPECT_EQ(progress().solved.contains(solvedTask(step)), done);
    };
    {
      SCOPED_TRACE("as the step shows it");
      expectDone(false);
    }
    {
      SCOPED_TRACE("the mistake");
      edit(task.mistake);
      expectDone(false);
    }
    {
      SCOPED_TRACE("the answer");
      click("taskAnswer");
      expectDone(true);
    }
    EXPECT_TRUE(text("taskPraise").contains(QString::fromStdString(task.praise)));
    EXPECT_TRUE(shown("showTry"));
  }
};

TEST_P(LessonWalkTest, FromTheListToItsEnd) {
  const LessonList list = loadLessons(lessonFolder());
  const Lesson& lesson = findLesson(list, GetParam());
  openFromList(lesson.name);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    SCOPED_TRACE("step " + std::to_string(i + 1));
    expectStep(lesson, i);
    if (HasFatalFailure()) return;
    const bool last = i + 1 == lesson.steps.size();
    EXPECT_FALSE(!last && progress().done);
    if (lesson.steps[i].question) answer(*lesson.steps[i].question, i);
    if (lesson.steps[i].task) perform(*lesson.steps[i].task, i);
    if (!qEnvironmentVariable("BOXPROBE_TEST_OUTPUT").isEmpty()) {
      waitUntilIdle();
      keepPicture(QString("lesson_%1_%2").arg(QString::fromStdString(lesson.name)).arg(i + 1));
    }
    if (i % 2 == 0) {
      key(i % 4 == 0 ? Qt::Key_Right : Qt::Key_PageDown);
    } else {
      click("lessonNext");
    }
  }
  EXPECT_TRUE(progress().done);
  EXPECT_TRUE(shown("lesson:" + QString::fromStdString(lesson.name))) << "the end leads to the list";
  click("leaveLessonsFromList");
  EXPECT_EQ(visit().lesson(), nullptr);
  EXPECT_TRUE(document().scene().models.empty()) << "the learner's own scene is back";
}

INSTANTIATE_TEST_SUITE_P(Every, LessonWalkTest, ::testing::ValuesIn(lessonNames()), [](const auto& about) {
  std::string name = about.param;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
});

}  // namespace
}  // namespace boxprobe
