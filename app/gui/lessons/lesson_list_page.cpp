// See lesson_list_page.h.
#include "app/gui/lessons/lesson_list_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>

#include "app/gui/lessons/lesson_progress.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/text_button.h"

namespace boxprobe {

LessonListPage::LessonListPage(QWidget* parent)
    : QWidget(parent),
      intro_(new QLabel(this)),
      leave_(new QPushButton(tr("Leave lessons"), this)),
      forget_(new QPushButton(tr("Forget progress"), this)),
      scroll_(new QScrollArea(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(8);
  auto* top = new QHBoxLayout;
  auto* title = new QLabel(tr("<b>Lessons</b>"), this);
  top->addWidget(title, 1);
  leave_->setObjectName("leaveLessonsFromList");
  leave_->setToolTip(tr("Closes the lessons and shows your own scene as you left it"));
  leave_->hide();
  top->addWidget(leave_);
  layout->addLayout(top);
  intro_->setWordWrap(true);
  intro_->setText(
      tr("Choose a lesson. Your own scene is kept unchanged and comes back when you leave. You can move everything in "
         "a lesson: your changes are your own attempt and never change the lesson."));
  layout->addWidget(intro_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layout->addWidget(scroll_, 1);
  forget_->setObjectName("forgetProgress");
  forget_->setToolTip(tr("Marks all lessons as not started"));
  layout->addWidget(forget_, 0, Qt::AlignLeft);  // Next stands at the right of a lesson's page
  connect(forget_, &QPushButton::clicked, this, &LessonListPage::forgetRequested);
  connect(leave_, &QPushButton::clicked, this, &LessonListPage::leaveRequested);
}

void LessonListPage::setLessonOpen(bool open) {
  leave_->setVisible(open);
}

void LessonListPage::addHeading(const QString& text) {
  auto* heading = new QLabel(text, scroll_->widget());
  heading->setWordWrap(true);
  heading->setContentsMargins(2, 10, 0, 0);
  heading->setStyleSheet("font-weight: bold");
  rows_->addWidget(heading);
}

void LessonListPage::show(const LessonList& list) {
  auto* content = new QWidget;
  rows_ = new QVBoxLayout(content);
  rows_->setContentsMargins(0, 0, 4, 0);
  rows_->setSpacing(5);
  scroll_->setWidget(content);  // the one before goes with its buttons
  buttons_.clear();
  std::string chapter;
  int number = 0;
  for (const Lesson& lesson : list.lessons) {
    if (lesson.chapter != chapter) addHeading(QString::fromStdString(lesson.chapter));
    chapter = lesson.chapter;
    const QString name = QString::fromStdString(lesson.name);
    auto* button = new TextButton(content);
    button->setObjectName("lesson:" + name);
    button->show(QString("%1. %2").arg(++number).arg(QString::fromStdString(lesson.title)),
                 QString::fromStdString(lesson.summary));
    connect(button, &TextButton::clicked, this, [this, name] { emit chosen(name); });
    rows_->addWidget(button);
    buttons_[name] = button;
  }
  addErrors(tr("These lessons cannot be read"), list.errors);
  addErrors(tr("Faults in the lessons' texts"), list.textErrors);
  rows_->addStretch(1);
}

void LessonListPage::addErrors(const QString& heading, const std::vector<std::string>& errors) {
  if (!errors.empty()) addHeading(heading);
  for (const std::string& error : errors) {
    QLabel* line = helpLabel(scroll_->widget());
    line->setTextFormat(Qt::PlainText);
    line->setText(QString::fromStdString(error));
    line->setTextInteractionFlags(Qt::TextSelectableByMouse);
    line->setProperty("lessonError", true);
    rows_->addWidget(line);
  }
}

void LessonListPage::showProgress(const LessonList& list, const QString& last) {
  bool any = false;
  for (const Lesson& lesson : list.lessons) {
    const QString name = QString::fromStdString(lesson.name);
    const auto found = buttons_.find(name);
    if (found == buttons_.end()) continue;
    const LessonProgress progress = lessonProgress(name);
    const auto steps = static_cast<int>(lesson.steps.size());
    const bool begun = progress.furthest >= 0;
    any = any || begun;
    QString heading = found->second->accessibleName();
    QString corner;
    if (progress.done) {
      corner = tr("done");
    } else if (begun) {
      corner = (name == last ? tr("go on, %1/%2") : tr("%1/%2")).arg(std::min(progress.furthest + 1, steps)).arg(steps);
    }
    found->second->show(heading, QString::fromStdString(lesson.summary), corner);
    found->second->setMark(progress.done ? TextButton::Mark::Right
                           : begun       ? TextButton::Mark::Begun
                                         : TextButton::Mark::Empty);
  }
  forget_->setEnabled(any);
}

void LessonListPage::bringForward(const QString& lesson) {
  const auto found = buttons_.find(lesson);
  if (found == buttons_.end()) return;
  found->second->setFocus();
  scroll_->ensureWidgetVisible(found->second);
}

}  // namespace boxprobe
