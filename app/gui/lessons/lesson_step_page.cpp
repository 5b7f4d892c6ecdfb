// See lesson_step_page.h.
#include "app/gui/lessons/lesson_step_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "app/gui/formula/formula_label.h"
#include "app/gui/lessons/lesson_exercise_box.h"
#include "app/gui/lessons/lesson_question_box.h"
#include "app/gui/lessons/lesson_task_box.h"
#include "app/lessons/formula_mathml.h"

namespace boxprobe {

namespace {

QLabel* textLabel(QWidget* parent, const char* name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

QPushButton* button(QWidget* parent, const QString& text, const char* name, const QString& toolTip) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(toolTip);
  return made;
}

}  // namespace

LessonStepPage::LessonStepPage(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->setSpacing(8);
  buildTop(layout);
  layout->addWidget(buildText(), 1);
  buildTry(layout);
  buildBottom(layout);
}

void LessonStepPage::buildTop(QVBoxLayout* layout) {
  auto* row = new QHBoxLayout;
  auto* list = button(this, tr("All lessons"), "lessonList", tr("Shows the list of lessons; this one stays open"));
  auto* leave = button(this, tr("Leave lessons"), "leaveLessons",
                       tr("Closes the lessons and shows your own scene as you left it"));
  row->addWidget(list);
  row->addStretch(1);
  row->addWidget(leave);
  layout->addLayout(row);
  lesson_ = textLabel(this, "help");
  title_ = textLabel(this, "stepTitle");
  layout->addWidget(lesson_);
  layout->addWidget(title_);
  connect(list, &QPushButton::clicked, this, &LessonStepPage::listRequested);
  connect(leave, &QPushButton::clicked, this, &LessonStepPage::leaveRequested);
}

QWidget* LessonStepPage::buildText() {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 6, 0);
  layout->setSpacing(12);
  say_ = textLabel(content, "stepText");
  formula_ = new FormulaLabel(content);
  formula_->setObjectName("stepFormula");
  mayMove_ = textLabel(content, "stepTry");
  question_ = new LessonQuestionBox(content);
  task_ = new LessonTaskBox(content);
  exercises_ = new LessonExerciseBox(content);
  for (QWidget* part :
       {static_cast<QWidget*>(say_), static_cast<QWidget*>(formula_), static_cast<QWidget*>(mayMove_),
        static_cast<QWidget*>(task_), static_cast<QWidget*>(question_), static_cast<QWidget*>(exercises_)}) {
    layout->addWidget(part);
  }
  layout->addStretch(1);
  connect(question_, &LessonQuestionBox::answered, this, &LessonStepPage::answered);
  connect(task_, &LessonTaskBox::answerRequested, this, &LessonStepPage::solutionRequested);
  scroll_ = new QScrollArea(this);
  scroll_->setWidget(content);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  return scroll_;
}

void LessonStepPage::buildTry(QVBoxLayout* layout) {
  tryLabel_ = textLabel(this, "help");
  layout->addWidget(tryLabel_);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  lessonScene_ = button(this, tr("Lesson's scene"), "showLessonScene",
                        tr("Shows the step as the lesson has it; your attempt is kept"));
  try_ = button(this, tr("Your try"), "showTry", tr("Shows your attempt at this step"));
  startOver_ = button(this, tr("Start over"), "startOver", tr("Discards your attempt. Undo restores it."));
  for (QPushButton* choice : {lessonScene_, try_}) {
    choice->setCheckable(true);
    row->addWidget(choice, 1);
  }
  row->addSpacing(8);
  row->addWidget(startOver_);
  layout->addLayout(row);
  connect(lessonScene_, &QPushButton::clicked, this, &LessonStepPage::lessonSceneRequested);
  connect(try_, &QPushButton::clicked, this, &LessonStepPage::tryRequested);
  connect(startOver_, &QPushButton::clicked, this, &LessonStepPage::startOverRequested);
}

void LessonStepPage::buildBottom(QVBoxLayout* layout) {
  auto* row = new QHBoxLayout;
  back_ = button(this, tr("Back"), "lessonBack", tr("Previous step (Left, Page Up)"));
  next_ = button(this, tr("Next"), "lessonNext", tr("Next step (Right, Page Down)"));
  position_ = new QLabel(this);
  position_->setObjectName("stepPosition");
  position_->setAlignment(Qt::AlignCenter);
  row->addWidget(back_, 1);
  row->addWidget(position_, 1);
  row->addWidget(next_, 1);
  layout->addLayout(row);
  connect(back_, &QPushButton::clicked, this, &LessonStepPage::backRequested);
  connect(next_, &QPushButton::clicked, this, &LessonStepPage::nextRequested);
}

void LessonStepPage::show(const Lesson& lesson, std::size_t index, const Solved& solved) {
  const LessonStep& step = lesson.steps[index];
  const auto text = [](const std::string& line) { return QString::fromStdString(line); };
  const QString note = lesson.unreviewed.empty() ? QString() : " (" + text(lesson.unreviewed) + ")";
  lesson_->setText(text(lesson.chapter) + ": " + text(lesson.title) + note);
  title_->setText(text(step.title));
  say_->setText(text(step.say));
  const QString mathml =
      step.formula.empty() ? QString() : QString("<math>%1</math>").arg(text(formulaMathml(step.formula)));
  formula_->setMathml(mathml, text(step.formula));
  // A curve takes a minute to measure, and what a probe holds stands in its panel: the window draws neither.
  const QString tries = step.mayMove.empty() ? QString() : tr("Try: %1").arg(text(step.mayMove));
  const QString what = step.curve ? tr("curve") : tr("map");
  const QString drawn =
      step.drawn() ? tr("boxprobe lessons %1 -o sheet.png draws the %2.").arg(text(lesson.name), what) : QString();
  mayMove_->setText(tries + (tries.isEmpty() || drawn.isEmpty() ? "" : "\n") + drawn);
  mayMove_->setVisible(!mayMove_->text().isEmpty());
  question_->setVisible(step.question.has_value());
  if (step.question) question_->show(*step.question, solved.question);
  task_->setVisible(step.task.has_value());
  if (step.task) task_->show(*step.task, solved.task);
  const auto count = static_cast<int>(lesson.steps.size()), number = static_cast<int>(index) + 1;
  exercises_->setVisible(number == count && !lesson.exercises.empty());
  if (number == count) exercises_->show(lesson.exercises);
  position_->setText(tr("Step %1 of %2").arg(number).arg(count));
  back_->setEnabled(index > 0);
  next_->setText(number < count ? tr("Next") : tr("Finish"));
  scroll_->verticalScrollBar()->setValue(0);
}

void LessonStepPage::showTry(bool lesson, bool kept) {
  lessonScene_->setChecked(lesson);
  try_->setChecked(!lesson);
  for (QWidget* part : {static_cast<QWidget*>(lessonScene_), static_cast<QWidget*>(try_),
                        static_cast<QWidget*>(startOver_), static_cast<QWidget*>(tryLabel_)}) {
    part->setVisible(kept);
  }
  tryLabel_->setText(lesson ? tr("This is the lesson's scene. Your attempt is kept.")
                            : tr("This is your attempt. The lesson's scene is kept."));
}

void LessonStepPage::showResult(const LessonCheck::Result& result) {
  task_->showResult(result);
}

void LessonStepPage::showWaiting() {
  task_->showWaiting();
}

void LessonStepPage::showFailure(const QString& line) {
  task_->showFailure(line);
}

}  // namespace boxprobe
