// Something to do to the scene, with the number that says how near it is. Called by the lesson's step page.
#pragma once

#include <QFrame>
#include <optional>

#include "app/gui/lessons/lesson_check.h"
#include "filters/core/scene/lesson.h"

class QLabel;
class QPushButton;

namespace boxprobe {

class LessonTaskBox : public QFrame {
  Q_OBJECT

 public:
  explicit LessonTaskBox(QWidget* parent = nullptr);

  /// `solved`: it was done before.
  void show(const LessonTask& task, bool solved);
  void showResult(const LessonCheck::Result& result);
  /// It is measured once the drag ends.
  void showWaiting();
  void showFailure(const QString& line);

 signals:
  void answerRequested();

 private:
  QString wantedText(const std::optional<double>& limit) const;

  LessonTask task_;
  bool solved_ = false;
  QLabel *ask_, *value_, *praise_;
  QPushButton* answer_;
};

/// "Error of the hit", "probes.room.box.max": what a measure is called.
QString measureLabel(const LessonMeasure& measure);

}  // namespace boxprobe
