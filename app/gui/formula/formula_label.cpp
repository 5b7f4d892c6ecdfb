// See formula_label.h.
#include "app/gui/formula/formula_label.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/gui/formula/mathml_layout.h"

namespace boxprobe {

namespace {

constexpr double kOfText = 1.25;  ///< letters, against those of the text around
constexpr int kMargin = 8;        ///< pixels

}  // namespace

FormulaLabel::FormulaLabel(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void FormulaLabel::setMathml(const QString& mathml, const QString& plainText) {
  box_ = mathml.isEmpty() ? MathBox() : layoutMathml(mathml);
  ink_ = box_.path.boundingRect();
  setAccessibleName(plainText);
  setToolTip(plainText);
  setVisible(!mathml.isEmpty());
  updateGeometry();
  update();
}

double FormulaLabel::em(int width) const {
  const double wanted = kOfText * fontInfo().pixelSize();
  const double room = std::max(width - 2 * kMargin, 1);
  return ink_.width() > 0.0 ? std::min(wanted, room / ink_.width()) : wanted;
}

QSize FormulaLabel::sizeHint() const {
  constexpr int kNarrowest = 200;
  const int width = static_cast<int>(std::ceil(ink_.width() * em(1 << 16))) + 2 * kMargin;
  return {std::min(width, kNarrowest), heightForWidth(width)};
}

int FormulaLabel::heightForWidth(int width) const {
  return static_cast<int>(std::ceil(ink_.height() * em(width))) + 2 * kMargin;
}

void FormulaLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().base());
  painter.drawRoundedRect(rect(), 5, 5);
  const double size = em(width());
  painter.translate(kMargin, 0.5 * (height() - ink_.height() * size));
  painter.scale(size, size);
  painter.translate(-ink_.topLeft());
  painter.fillPath(box_.path, palette().color(QPalette::Text));
}

void FormulaLabel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) updateGeometry();
  QWidget::changeEvent(event);
}

}  // namespace boxprobe
