// A lesson's exercises, for paper: each with a solution that shows when it is asked for. Called by the lesson's step
// page, at the end of a lesson.
#pragma once

#include <QFrame>
#include <vector>

#include "filters/core/scene/lesson.h"

class QVBoxLayout;

namespace boxprobe {

class LessonExerciseBox : public QFrame {
  Q_OBJECT

 public:
  explicit LessonExerciseBox(QWidget* parent = nullptr);
  /// All solutions folded.
  void show(const std::vector<LessonExercise>& exercises);

 private:
  void add(const LessonExercise& exercise, int number);

  QVBoxLayout* rows_;
  QWidget* content_ = nullptr;
};

}  // namespace boxprobe
