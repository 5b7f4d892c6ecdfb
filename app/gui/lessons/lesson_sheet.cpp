// See lesson_sheet.h.
#include "app/gui/lessons/lesson_sheet.h"

#include <QPainter>
#include <QTextDocument>
#include <algorithm>
#include <cmath>
#include <memory>

#include "app/gui/formula/formula_picture.h"
#include "app/lessons/formula_mathml.h"

namespace boxprobe {

namespace {

constexpr int kMargin = 28, kGap = 22, kColumns = 3;
constexpr double kFormulaPoints = 15.0;

const QColor& ink() {
  static const QColor color("#1d2126");
  return color;
}

QString escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped();
}

/// Rich text of a width, to be drawn once its height is known.
class Block {
 public:
  Block(const QString& content, int width) : document_(std::make_shared<QTextDocument>()) {
    QFont font("DejaVu Sans");
    font.setPixelSize(15);
    document_->setDefaultFont(font);
    document_->setDocumentMargin(0);
    document_->setTextWidth(width);
    document_->setHtml("<div style=\"color:" + ink().name() + "\">" + content + "</div>");
  }
  int height() const { return static_cast<int>(std::ceil(document_->size().height())); }
  void paint(QPainter& painter, int x, int y) const {
    painter.save();
    painter.translate(x, y);
    document_->drawContents(&painter);
    painter.restore();
  }

 private:
  std::shared_ptr<QTextDocument> document_;
};

/// A step without its picture.
struct Caption {
  Block above;
  QImage formula;
  Block below;
  int height() const { return above.height() + (formula.isNull() ? 6 : formula.height() + 14) + below.height() + 8; }
};

QString questionHtml(const LessonStep& step) {
  QString text;
  if (!step.mayMove.empty()) text += "<p><b>Try it:</b> " + escaped(step.mayMove) + "</p>";
  if (step.question) {
    text += "<p><b>Question:</b> " + escaped(step.question->ask) + "</p><ul style=\"margin-top:2px\">";
    for (const LessonAnswer& answer : step.question->answers) text += "<li>" + escaped(answer.text) + "</li>";
    text += "</ul>";
  }
  if (step.task) text += "<p><b>Task:</b> " + escaped(step.task->ask) + "</p>";
  return text;
}

Caption caption(const LessonStep& step, std::size_t number, int width) {
  const QString above =
      QString("<p style=\"font-size:18px; margin-bottom:4px\"><b>%1&ensp;%2</b></p><p style=\"margin-top:0\">%3</p>")
          .arg(number + 1)
          .arg(escaped(step.title), escaped(step.say));
  QImage formula;
  if (!step.formula.empty()) {
    formula = formulaPicture(QString::fromStdString(formulaMathml(step.formula)), kFormulaPoints, ink(), 1.0);
    if (formula.width() > width) formula = formula.scaledToWidth(width, Qt::SmoothTransformation);
  }
  return {Block(above, width), formula, Block(questionHtml(step), width)};
}

QString measuredHtml(const LessonPictures& pictures) {
  QString text;
  for (const LessonPictures::Claim& claim : pictures.claims) {
    text += "<p style=\"margin-top:2px; margin-bottom:2px\">" + escaped(claim.say) + " <b>" + escaped(claim.measured) +
            "</b>" + (claim.holds ? "" : " <b style=\"color:#b00020\">does not hold</b>") + "</p>";
  }
  return text.isEmpty() ? text : "<p style=\"margin-bottom:2px\"><b>Measured</b></p>" + text;
}

/// Without the solutions: a sheet is handed out.
QString exercisesHtml(const Lesson& lesson) {
  QString text;
  for (const LessonExercise& exercise : lesson.exercises) {
    text += "<p style=\"margin-top:6px; margin-bottom:2px\"><b>Exercise:</b> " + escaped(exercise.ask) + "</p>";
  }
  return text;
}

}  // namespace

QImage lessonSheet(const Lesson& lesson, const LessonPictures& pictures) {
  const int width = pictures.steps.front().width(), pictureHeight = pictures.steps.front().height();
  const int count = static_cast<int>(lesson.steps.size());
  // Four are two rows of two.
  const int columns = count <= kColumns ? count : count == 4 ? 2 : kColumns;
  const int paper = 2 * kMargin + columns * (width + kGap) - kGap;
  const int inner = paper - 2 * kMargin;
  const Block heading(
      QString("<p style=\"font-size:14px; margin-bottom:0; color:#5a626c\">%1</p>"
              "<p style=\"font-size:27px; margin-top:2px; margin-bottom:2px\"><b>%2</b></p>"
              "<p style=\"margin-top:0; font-size:16px\">%3</p>")
          .arg(escaped(lesson.chapter + (lesson.unreviewed.empty() ? "" : "  (" + lesson.unreviewed + ")")),
               escaped(lesson.title), escaped(lesson.summary)),
      inner);
  const Block measured(measuredHtml(pictures) + exercisesHtml(lesson), inner);

  std::vector<Caption> captions;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) captions.push_back(caption(lesson.steps[i], i, width));
  std::vector<int> rowHeights;
  for (int i = 0; i < count; ++i) {
    if (i % columns == 0) rowHeights.push_back(0);
    rowHeights.back() =
        std::max(rowHeights.back(), pictureHeight + 10 + captions[static_cast<std::size_t>(i)].height());
  }
  int height = 2 * kMargin + heading.height() + 12 + measured.height();
  for (const int row : rowHeights) height += row + kGap;

  QImage sheet(paper, height, QImage::Format_RGB888);
  sheet.fill(Qt::white);
  QPainter painter(&sheet);
  painter.setRenderHint(QPainter::TextAntialiasing);
  int y = kMargin;
  heading.paint(painter, kMargin, y);
  y += heading.height() + 12;
  for (int i = 0; i < count; ++i) {
    const Caption& text = captions[static_cast<std::size_t>(i)];
    const int x = kMargin + i % columns * (width + kGap);
    int below = y + pictureHeight + 10;
    painter.drawImage(x, y, pictures.steps[static_cast<std::size_t>(i)]);
    text.above.paint(painter, x, below);
    below += text.above.height();
    if (text.formula.isNull()) {
      below += 6;
    } else {
      painter.drawImage(x, below + 6, text.formula);
      below += text.formula.height() + 14;
    }
    text.below.paint(painter, x, below);
    if (i % columns == columns - 1 || i == count - 1) y += rowHeights[static_cast<std::size_t>(i / columns)] + kGap;
  }
  measured.paint(painter, kMargin, y);
  return sheet;
}

}  // namespace boxprobe
