// What the pages of lessons say and do without a window, against lesson_values.txt.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QPushButton>

#include "app/gui/formula/formula_label.h"
#include "app/gui/lessons/lesson_check.h"
#include "app/gui/lessons/lesson_list_page.h"
#include "app/gui/lessons/lesson_panel.h"
#include "app/gui/lessons/lesson_pictures.h"
#include "app/gui/lessons/lesson_progress.h"
#include "app/gui/lessons/lesson_step_page.h"
#include "app/gui/lessons/lesson_task_box.h"
#include "app/gui/widgets/text_button.h"
#include "tests/gui/some_lesson.h"
#include "tests/gui/value_lines.h"
#include "tests/gui/window_test.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

void addLessonPages(ValueLines& lines) {
  const Lesson lesson = someLesson();
  for (const bool solved : {false, true}) {
    LessonStepPage page;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      page.show(lesson, i, {solved, solved});
      page.showTry(i % 2 == 0, solved);
      lines.tree("step " + std::to_string(i) + (solved ? " solved" : ""), page);
    }
  }
  LessonStepPage page;
  page.show(lesson, 2, {});
  const auto said = [&](const std::string& after) {
    for (const char* name : {"reply", "taskValue", "taskPraise"}) {
      const auto* label = page.findChild<QLabel*>(name);
      lines.add(after + " " + name, label->isHidden() ? "" : label->text());
    }
    for (const TextButton* button : page.findChildren<TextButton*>()) {
      lines.add(after + " mark of " + button->objectName().toStdString(), static_cast<int>(button->mark()));
    }
  };
  QStringList answered;
  QObject::connect(&page, &LessonStepPage::answered, [&](bool right) { answered += right ? "right" : "wrong"; });
  for (const char* name : {"answer0", "answer1", "answer0"}) {
    page.findChild<TextButton*>(name)->click();
    said(std::string("after ") + name);
  }
  page.show(lesson, 1, {});
  for (const char* name : {"answer1", "answer2", "answer0"}) {
    page.findChild<TextButton*>(name)->click();
    said(std::string("of the other after ") + name);
  }
  lines.add("answered", answered.join(" "));
  Lesson asked = lesson;
  LessonTask& task = *asked.steps[2].task;
  for (const Comparison comparison : {Comparison::Above, Comparison::Below, Comparison::Within}) {
    task.done.comparison = comparison;
    task.done.tolerance = 0.05;
    const std::string kind = "comparison " + std::to_string(static_cast<int>(comparison));
    page.show(asked, 2, {});
    page.showWaiting();
    said(kind + " waiting");
    page.showResult({0.41, 0.37, false});
    said(kind + " not done");
    page.showResult({{}, 0.37, false});
    said(kind + " undefined");
    page.showResult({0.41, {}, false});
    said(kind + " with what is undefined");
    page.showResult({0.36, 0.37, true});
    said(kind + " done");
    page.showResult({0.41, 0.37, false});
    said(kind + " no more");
    page.showFailure("it cannot");
    said(kind + " fails");
  }
  for (int i = 1; i <= 2; ++i) {
    page.show(lesson, 4, {});
    auto* solution = page.findChild<QPushButton*>(QString("showSolution%1").arg(i));
    for (const bool open : {true, false}) {
      solution->click();
      const auto* shown = page.findChild<QLabel*>(QString("solution%1").arg(i));
      lines.add("solution " + std::to_string(i) + (open ? " open" : " shut"),
                solution->text() + (shown->isHidden() ? " hidden " : " shown ") + shown->text());
      for (const FormulaLabel* formula : page.findChildren<FormulaLabel*>()) {
        lines.add("its formula", (formula->isHidden() ? "hidden " : "shown ") + formula->toolTip());
      }
    }
  }

  LessonList list;
  list.lessons = {lesson, lesson, lesson, lesson};
  const char* const names[] = {"first", "second", "third", "fourth"};
  for (std::size_t i = 0; i < 4; ++i) list.lessons[i].name = names[i];
  list.lessons[2].chapter = list.lessons[3].chapter = "Other things";
  list.errors = {"4-broken.lesson.json: <b>: there is no scene"};
  list.textErrors = {"text/de.json: one", "text/de.json: two"};
  forgetLessons();
  LessonListPage listed;
  QStringList asks;
  QObject::connect(&listed, &LessonListPage::chosen, [&](const QString& name) { asks += name; });
  QObject::connect(&listed, &LessonListPage::forgetRequested, [&] { asks += "forget"; });
  QObject::connect(&listed, &LessonListPage::leaveRequested, [&] { asks += "leave"; });
  listed.show(list);
  listed.showProgress(list, {});
  lines.tree("list", listed);
  keepLessonProgress("first", {4, true, {solvedQuestion(1), solvedTask(2)}});
  keepLessonProgress("second", {1, false, {}});
  keepLessonProgress("third", {12, false, {}});
  keepLastLesson("second");
  listed.setLessonOpen(true);
  listed.showProgress(list, lastLesson());
  lines.tree("list with progress", listed);
  for (const TextButton* button : listed.findChildren<TextButton*>()) {
    lines.add("mark of " + button->objectName().toStdString(), static_cast<int>(button->mark()));
    const QImage corner = const_cast<TextButton*>(button)->grab().toImage();
    lines.add("height", corner.height() > 0 ? 1 : 0);
  }
  for (const char* name : {"lesson:third", "forgetProgress", "leaveLessonsFromList"}) {
    listed.findChild<QAbstractButton*>(name)->click();
  }
  lines.add("asked", asks.join(" "));
  const LessonProgress kept = lessonProgress("first");
  QStringList solved(kept.solved.begin(), kept.solved.end());
  solved.sort();
  lines.add("progress", QString("%1 %2 ").arg(kept.furthest).arg(kept.done) + solved.join(", "));
  forgetLessons();
  lines.add("forgotten", QString("%1 '%2'").arg(lessonProgress("first").furthest).arg(lastLesson()));
  LessonPanel panel;
  panel.showStep();
  lines.add("step shown", panel.stepShown() ? "yes" : "no");
  panel.setTypeSize(20);
  lines.add("type", panel.styleSheet());
  panel.showList();
  lines.add("step shown", panel.stepShown() ? "yes" : "no");
}

void addMeasures(ValueLines& lines) {
  for (int kind = 0; kind <= static_cast<int>(MeasureKind::Fit); ++kind) {
    LessonMeasure measure;
    measure.kind = static_cast<MeasureKind>(kind);
    for (const char* name : {"hit-error", "probes/0/weight", "surface/position/1", "7", "/", ""}) {
      measure.name = name;
      lines.add("measure " + std::to_string(kind) + " " + name, measureLabel(measure));
    }
  }
  LessonCondition condition;
  condition.limit = 0.375;
  condition.tolerance = 0.0125;
  for (const Comparison comparison : {Comparison::Above, Comparison::Below, Comparison::Within}) {
    condition.comparison = comparison;
    for (const char* unit : {"", "m", "%"}) {
      for (const std::optional<double> divisor :
           {std::optional<double>(), std::optional<double>(0.25), std::optional<double>(0.0)}) {
        lines.add("claim", QString::fromStdString(claimText(condition, unit, {0.625, 0.375, divisor, true})));
      }
    }
  }

  // What is measured when, and what comes of it.
  bool ready = false, dragging = false;
  double value = 0.5;
  QStringList told;
  LessonCheck check({[&] { return ready; }, [&] { return dragging; },
                     [&](const LessonMeasure& measure) -> std::optional<double> {
                       told += "measures " + QString::fromStdString(measure.name);
                       if (value < 0.0) throw std::runtime_error("no\nvalue");
                       if (measure.name == "nowhere") return std::nullopt;
                       return measure.name == "times" ? 4.0 : value;
                     }});
  QObject::connect(&check, &LessonCheck::measured, [&] {
    const auto text = [](const std::optional<double>& number) { return number ? QString::number(*number) : "nothing"; };
    const LessonCheck::Result& result = *check.result();
    told += QString("%1 of %2 %3").arg(text(result.value), text(result.limit)).arg(result.done);
  });
  QObject::connect(&check, &LessonCheck::waiting, [&] { told += "waits"; });
  QObject::connect(&check, &LessonCheck::failed, [&](const QString& line) { told += "fails: " + line; });
  LessonTask task;
  task.done.measure.name = "value";
  task.done.limit = 0.6;
  const auto settle = [&](const std::string& what) {
    EXPECT_TRUE(waitFor([&] { return !told.isEmpty(); })) << what;
    lines.add("check " + what, told.join(", ") + (check.pending() ? ", pending" : ""));
    told.clear();
  };
  check.invalidate();
  lines.add("check of nothing", check.pending() ? "pending" : "done");
  ready = true;
  check.setTask(task);
  settle("below");
  task.done.times = LessonMeasure();
  task.done.times->name = "times";
  task.done.comparison = Comparison::Above;
  check.setTask(task);
  settle("above times");
  task.done.times->name = "nowhere";
  check.setTask(task);
  settle("above times nothing");
  std::swap(*task.done.times, task.done.measure);
  check.setTask(task);
  settle("of nothing above times");
  task.done.measure.name = "value";
  value = -1.0;
  check.setTask(task);
  settle("that throws");
  value = 0.5;
  dragging = true;
  task.done.times.reset();
  check.setTask(task);
  settle("in a drag");
  dragging = false;
  check.invalidate();
  settle("after the drag");
  check.setTask({});
  lines.add("check of none again", check.pending() || check.result() ? "something" : "nothing");
}

TEST(LessonValues, OfPagesTasksAndMeasuresAreAsBefore) {
  if (!widgetLinesHold()) GTEST_SKIP() << "kept for another Qt than " << qVersion();
  ValueLines lines;
  addLessonPages(lines);
  addMeasures(lines);
  expectKeptWidgets("gui/values/lesson_values.txt", lines.lines());
}

}  // namespace
}  // namespace boxprobe
