// See lesson_task_box.h.
#include "app/gui/lessons/lesson_task_box.h"

#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>

#include "app/gui/widgets/table_words.h"
#include "app/lessons/lesson_measure.h"
#include "filters/core/scene/surface_view.h"

namespace boxprobe {

LessonTaskBox::LessonTaskBox(QWidget* parent)
    : QFrame(parent),
      ask_(new QLabel(this)),
      value_(new QLabel(this)),
      praise_(new QLabel(this)),
      answer_(new QPushButton(tr("Show the answer"), this)) {
  setObjectName("lessonTask");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  for (QLabel* label : {ask_, value_, praise_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    layout->addWidget(label);
  }
  ask_->setStyleSheet("font-weight: bold");
  value_->setObjectName("taskValue");
  praise_->setObjectName("taskPraise");
  answer_->setObjectName("taskAnswer");
  answer_->setToolTip(tr("Solves the task for you, as an edit that you can undo"));
  layout->addWidget(answer_, 0, Qt::AlignLeft);
  connect(answer_, &QPushButton::clicked, this, &LessonTaskBox::answerRequested);
}

void LessonTaskBox::show(const LessonTask& task, bool solved) {
  task_ = task;
  solved_ = solved;
  ask_->setText(QString::fromStdString(task.ask));
  value_->setText(tr("Measuring..."));
  praise_->setText(solved ? tr("You have solved this task.") : QString());
  praise_->setVisible(solved);
  answer_->setVisible(!task.solution.empty());
}

QString LessonTaskBox::wantedText(const std::optional<double>& limit) const {
  if (!limit) return tr("what it is compared with is undefined here");
  const QString text = QString::fromStdString(measuredText(*limit, task_.unit));
  switch (task_.done.comparison) {
    case Comparison::Above:
      return tr("done above %1").arg(text);
    case Comparison::Below:
      return tr("done below %1").arg(text);
    case Comparison::Within:
      break;
  }
  return tr("solved at %1 ± %2").arg(text, QString::fromStdString(measuredText(task_.done.tolerance, task_.unit)));
}

void LessonTaskBox::showResult(const LessonCheck::Result& result) {
  const QString name = measureLabel(task_.done.measure);
  const QString now =
      result.value ? QString::fromStdString(measuredText(*result.value, task_.unit)) : tr("undefined here");
  value_->setText(tr("%1: %2 (%3)").arg(name, now, wantedText(result.limit)));
  solved_ = solved_ || result.done;
  praise_->setVisible(solved_);
  if (result.done) {
    praise_->setText(tr("Done. %1").arg(QString::fromStdString(task_.praise)));
  } else if (solved_) {
    praise_->setText(tr("You have solved this task."));
  }
}

void LessonTaskBox::showWaiting() {
  value_->setText(tr("Let go to measure; with Shift handles move finely"));
}

void LessonTaskBox::showFailure(const QString& line) {
  value_->setText(line);
}

QString measureLabel(const LessonMeasure& measure) {
  switch (measure.kind) {
    case MeasureKind::Error:
      return LessonTaskBox::tr("Error of the picture");
    case MeasureKind::Difference:
      return LessonTaskBox::tr("Difference between the pictures");
    case MeasureKind::Mean:
      return LessonTaskBox::tr("Mean light");
    case MeasureKind::Bend:
      return LessonTaskBox::tr("Curvature");
    case MeasureKind::Jump:
      return LessonTaskBox::tr("Largest jump between two pixels");
    case MeasureKind::Broken:
      return LessonTaskBox::tr("Share of lookups that are not a number");
    case MeasureKind::Turned:
      return LessonTaskBox::tr("Angle off the right lookup, degrees");
    case MeasureKind::View:
      if (const auto row = findSurfaceView(measure.name)) {
        return tableWords(surfaceViews()[static_cast<std::size_t>(*row)].label);
      }
      break;
    case MeasureKind::Fit:
    case MeasureKind::Explain: {
      // The last key of the pointer says what it is, an index alone does not.
      const QStringList keys = QString::fromStdString(measure.name).split('/');
      const bool index = !keys.last().isEmpty() && keys.last()[0].isDigit() && keys.size() > 1;
      QString label = index ? keys[keys.size() - 2] + " " + keys.last() : keys.last();
      if (!label.isEmpty()) label[0] = label[0].toUpper();
      return label;
    }
    case MeasureKind::Counter:
    case MeasureKind::Field:
      break;
  }
  return QString::fromStdString(measure.name);
}

}  // namespace boxprobe
