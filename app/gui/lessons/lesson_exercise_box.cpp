// See lesson_exercise_box.h.
#include "app/gui/lessons/lesson_exercise_box.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/formula/formula_label.h"
#include "app/lessons/formula_mathml.h"

namespace boxprobe {

namespace {

QLabel* textLabel(QWidget* parent, const QString& text) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

LessonExerciseBox::LessonExerciseBox(QWidget* parent) : QFrame(parent), rows_(new QVBoxLayout(this)) {
  setObjectName("lessonExercises");
  rows_->setContentsMargins(0, 0, 0, 0);
}

void LessonExerciseBox::show(const std::vector<LessonExercise>& exercises) {
  delete content_;
  content_ = new QWidget(this);
  auto* layout = new QVBoxLayout(content_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  rows_->addWidget(content_);
  for (std::size_t i = 0; i < exercises.size(); ++i) add(exercises[i], static_cast<int>(i) + 1);
}

void LessonExerciseBox::add(const LessonExercise& exercise, int number) {
  QLayout* layout = content_->layout();
  QLabel* ask = textLabel(content_, tr("Exercise %1. %2").arg(number).arg(QString::fromStdString(exercise.ask)));
  ask->setStyleSheet("font-weight: bold");
  auto* show = new QPushButton(tr("Show the solution"), content_);
  show->setObjectName(QString("showSolution%1").arg(number));
  show->setCheckable(true);
  QLabel* solution = textLabel(content_, QString::fromStdString(exercise.solution));
  solution->setObjectName(QString("solution%1").arg(number));
  auto* formula = new FormulaLabel(content_);
  if (!exercise.formula.empty()) {
    const QString mathml = QString::fromStdString(formulaMathml(exercise.formula));
    formula->setMathml("<math>" + mathml + "</math>", QString::fromStdString(exercise.formula));
  }
  for (QWidget* part : {static_cast<QWidget*>(ask), static_cast<QWidget*>(show), static_cast<QWidget*>(solution),
                        static_cast<QWidget*>(formula)}) {
    layout->addWidget(part);
  }
  const bool hasFormula = !exercise.formula.empty();
  const auto fold = [solution, formula, show, hasFormula](bool open) {
    solution->setVisible(open);
    formula->setVisible(open && hasFormula);
    show->setText(open ? tr("Hide the solution") : tr("Show the solution"));
  };
  fold(false);
  connect(show, &QPushButton::toggled, solution, fold);
}

}  // namespace boxprobe
