// A question with its answers as buttons: what is chosen is told right or wrong, with why, and can be chosen again.
// Called by the lesson's step page.
#pragma once

#include <QFrame>
#include <vector>

#include "filters/core/scene/lesson.h"

class QLabel;
class QVBoxLayout;

namespace boxprobe {

class TextButton;

class LessonQuestionBox : public QFrame {
  Q_OBJECT

 public:
  explicit LessonQuestionBox(QWidget* parent = nullptr);

  /// `solved`: it was answered before.
  void show(const LessonQuestion& question, bool solved);

 signals:
  void answered(bool right);

 private:
  void choose(std::size_t index);

  LessonQuestion question_;
  QLabel* ask_;
  QVBoxLayout* rows_;
  QLabel* reply_;
  std::vector<TextButton*> buttons_;
};

}  // namespace boxprobe
