// See lesson_question_box.h.
#include "app/gui/lessons/lesson_question_box.h"

#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/widgets/text_button.h"

namespace boxprobe {

LessonQuestionBox::LessonQuestionBox(QWidget* parent)
    : QFrame(parent), ask_(new QLabel(this)), rows_(new QVBoxLayout), reply_(new QLabel(this)) {
  setObjectName("lessonQuestion");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  ask_->setWordWrap(true);
  ask_->setTextFormat(Qt::PlainText);
  ask_->setStyleSheet("font-weight: bold");
  layout->addWidget(ask_);
  rows_->setSpacing(5);
  layout->addLayout(rows_);
  reply_->setObjectName("reply");
  reply_->setWordWrap(true);
  reply_->setTextFormat(Qt::PlainText);
  layout->addWidget(reply_);
}

void LessonQuestionBox::show(const LessonQuestion& question, bool solved) {
  question_ = question;
  ask_->setText(QString::fromStdString(question.ask));
  for (TextButton* button : buttons_) button->deleteLater();
  buttons_.clear();
  for (std::size_t i = 0; i < question.answers.size(); ++i) {
    auto* button = new TextButton(this);
    button->setObjectName(QString("answer%1").arg(i));
    button->show({}, QString::fromStdString(question.answers[i].text));
    button->setMark(TextButton::Mark::Empty);
    connect(button, &TextButton::clicked, this, [this, i] { choose(i); });
    rows_->addWidget(button);
    buttons_.push_back(button);
  }
  reply_->clear();
  reply_->hide();
  if (!solved) return;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    if (question.answers[i].right) buttons_[i]->setMark(TextButton::Mark::Right);
  }
  reply_->setText(tr("You have answered this question."));
  reply_->show();
}

void LessonQuestionBox::choose(std::size_t index) {
  const LessonAnswer& answer = question_.answers[index];
  for (TextButton* button : buttons_) button->setMark(TextButton::Mark::Empty);
  buttons_[index]->setMark(answer.right ? TextButton::Mark::Right : TextButton::Mark::Wrong);
  const QString why = QString::fromStdString(answer.reply);
  const bool saysSo = why.startsWith(tr("Yes"));
  reply_->setText(answer.right ? (saysSo ? why : tr("Right. %1").arg(why)) : tr("Not this one. %1").arg(why));
  reply_->show();
  emit answered(answer.right);
}

}  // namespace boxprobe
