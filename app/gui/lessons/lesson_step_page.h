// One step of a lesson to read and to do: text, formula, what to try, question, task, the learner's try beside the
// lesson's scene, back and next. Called by the lesson panel; knows no scene.
#pragma once

#include <QWidget>

#include "app/gui/lessons/lesson_check.h"
#include "filters/core/scene/lesson.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace boxprobe {

class FormulaLabel;
class LessonExerciseBox;
class LessonQuestionBox;
class LessonTaskBox;

class LessonStepPage : public QWidget {
  Q_OBJECT

 public:
  explicit LessonStepPage(QWidget* parent = nullptr);

  struct Solved {
    bool question = false, task = false;
  };
  void show(const Lesson& lesson, std::size_t step, const Solved& solved);
  /// `lesson`: its own scene is on show; `kept`: there is a try.
  void showTry(bool lesson, bool kept);
  void showResult(const LessonCheck::Result& result);
  void showWaiting();
  void showFailure(const QString& line);

 signals:
  void listRequested();
  void leaveRequested();
  void backRequested();
  void nextRequested();
  void answered(bool right);
  void solutionRequested();
  void lessonSceneRequested();
  void tryRequested();
  void startOverRequested();

 private:
  void buildTop(QVBoxLayout* layout);
  QWidget* buildText();
  void buildTry(QVBoxLayout* layout);
  void buildBottom(QVBoxLayout* layout);

  QLabel *lesson_, *title_, *say_, *mayMove_, *position_, *tryLabel_;
  FormulaLabel* formula_;
  LessonQuestionBox* question_;
  LessonTaskBox* task_;
  LessonExerciseBox* exercises_;
  QScrollArea* scroll_;
  QPushButton *lessonScene_, *try_, *startOver_, *back_, *next_;
};

}  // namespace boxprobe
