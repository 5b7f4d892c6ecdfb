// A learner at the window: opens lessons from the list, presses the panel's real buttons, waits for what is measured.
#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QString>
#include <string>

#include "app/gui/lessons/lesson_view.h"
#include "filters/io/scene/lesson_file.h"
#include "tests/gui/window_test.h"

namespace boxprobe {

std::string lessonFolder();

class LessonWindowTest : public WindowTest {
 protected:
  void SetUp() override;
  void TearDown() override;
  /// The learner's own scene: none, so that nothing is captured before the lesson.
  LoadedScene scene() const override { return {}; }

  LessonView& lessons() { return window_->lessons(); }
  const LessonVisit& visit() { return lessons().visit(); }
  /// By its name among the window's widgets; scrolled to and clicked in its middle.
  void click(const QString& button);
  QAbstractButton* button(const QString& name);
  QString text(const QString& label);
  bool shown(const QString& label);
  /// F1, then the lesson's button in the list.
  void openFromList(const std::string& lesson);
  /// Until the task has been measured on what is on show now.
  void waitForMeasure();
  /// What a learner does to the scene by whatever controls, as one edit.
  void edit(const std::vector<std::string>& assignments);
  /// For a look at it: kept where BOXPROBE_TEST_OUTPUT says.
  void keepPicture(const QString& name);
};

}  // namespace boxprobe
