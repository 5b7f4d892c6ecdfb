// See text_button.h.
#include "app/gui/widgets/text_button.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPen>
#include <cmath>

namespace boxprobe {

namespace {

constexpr int kMargin = 9, kGap = 3;  ///< pixels
const QColor kRight(0x5f, 0xc8, 0x7a), kWrong(0xe8, 0x6a, 0x5c);

QFont bold(QFont font) {
  font.setBold(true);
  return font;
}

QRectF textBox(const QFont& font, double width, const QString& text) {
  if (text.isEmpty()) return {};
  return QFontMetricsF(font).boundingRect(QRectF(0.0, 0.0, width, 1e4), Qt::TextWordWrap, text);
}

}  // namespace

struct TextButton::Layout {
  QRectF mark, heading, corner, body;
  double height = 0.0;
};

TextButton::TextButton(QWidget* parent) : QAbstractButton(parent) {
  // As high as its width asks for: a list that is scrolled would else count the height of the usual width, and end in
  // nothing.
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Maximum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);  // it is drawn lighter under the pointer
  setCursor(Qt::PointingHandCursor);
}

void TextButton::show(const QString& heading, const QString& body, const QString& corner) {
  heading_ = heading;
  body_ = body;
  corner_ = corner;
  setAccessibleName(heading.isEmpty() ? body : heading);
  updateGeometry();
  update();
}

void TextButton::setMark(Mark mark) {
  mark_ = mark;
  updateGeometry();
  update();
}

TextButton::Layout TextButton::layOut(int width) const {
  Layout layout;
  const double line = QFontMetricsF(font()).height();
  double left = kMargin;
  if (mark_ != Mark::None) {
    layout.mark = QRectF(left, kMargin + 0.1 * line, 0.8 * line, 0.8 * line);
    left += 0.8 * line + kMargin;
  }
  const double right = width - kMargin;
  double top = kMargin;
  if (!heading_.isEmpty()) {
    const double cornerWidth = corner_.isEmpty() ? 0.0 : QFontMetricsF(font()).horizontalAdvance(corner_) + kMargin;
    const QRectF box = textBox(bold(font()), right - left - cornerWidth, heading_);
    layout.heading = QRectF(left, top, right - left - cornerWidth, box.height());
    layout.corner = QRectF(right - cornerWidth, top, cornerWidth, line);
    top += box.height() + (body_.isEmpty() ? 0 : kGap);
  }
  if (!body_.isEmpty()) {
    layout.body = QRectF(left, top, right - left, textBox(font(), right - left, body_).height());
    top += layout.body.height();
  }
  layout.height = top + kMargin;
  return layout;
}

QSize TextButton::sizeHint() const {
  constexpr int kUsual = 260;
  return {kUsual, heightForWidth(kUsual)};
}

QSize TextButton::minimumSizeHint() const {
  constexpr int kNarrowest = 120;
  return {kNarrowest, static_cast<int>(std::ceil(QFontMetricsF(font()).height() + 2.0 * kMargin))};
}

int TextButton::heightForWidth(int width) const {
  return static_cast<int>(std::ceil(layOut(width).height));
}

void TextButton::paintMark(QPainter& painter, const QRectF& square) const {
  const double s = square.width();
  const auto at = [&](double x, double y) { return square.topLeft() + QPointF(x * s, y * s); };
  const QColor dim = palette().color(QPalette::Disabled, QPalette::WindowText);
  if (mark_ == Mark::Right || mark_ == Mark::Wrong) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(mark_ == Mark::Right ? kRight : kWrong);
    painter.drawEllipse(square);
    painter.setPen(QPen(palette().color(QPalette::Base), 0.13 * s, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (mark_ == Mark::Right) {
      painter.drawPolyline(QPolygonF({at(0.26, 0.52), at(0.44, 0.7), at(0.75, 0.33)}));
    } else {
      painter.drawLine(at(0.32, 0.32), at(0.68, 0.68));
      painter.drawLine(at(0.68, 0.32), at(0.32, 0.68));
    }
    return;
  }
  painter.setPen(QPen(mark_ == Mark::Begun ? palette().color(QPalette::Highlight) : dim, 0.09 * s));
  painter.setBrush(Qt::NoBrush);
  const QRectF ring = square.adjusted(0.05 * s, 0.05 * s, -0.05 * s, -0.05 * s);
  painter.drawEllipse(ring);
  if (mark_ != Mark::Begun) return;
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawPie(ring, 90 * 16, -180 * 16);
}

void TextButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Layout layout = layOut(width());
  QColor ground = palette().color(QPalette::Button);
  if (isEnabled() && (underMouse() || hasFocus())) ground = ground.lighter(118);
  if (isDown()) ground = ground.darker(115);
  QColor edge = hasFocus() ? palette().color(QPalette::Highlight) : ground.lighter(115);
  if (mark_ == Mark::Wrong) edge = kWrong;
  if (mark_ == Mark::Right && heading_.isEmpty()) edge = kRight;
  painter.setPen(QPen(edge, 1.2));
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.8, 0.8, -0.8, -0.8), 5, 5);
  if (mark_ != Mark::None) paintMark(painter, layout.mark);
  const QColor text = palette().color(QPalette::ButtonText);
  QColor quiet = text;
  quiet.setAlphaF(0.75);
  painter.setFont(bold(font()));
  painter.setPen(text);
  painter.drawText(layout.heading, Qt::TextWordWrap, heading_);
  painter.setFont(font());
  painter.setPen(heading_.isEmpty() ? text : quiet);
  painter.drawText(layout.body, Qt::TextWordWrap, body_);
  painter.setPen(quiet);
  painter.drawText(layout.corner, Qt::AlignRight | Qt::AlignTop, corner_);
}

void TextButton::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
  QAbstractButton::keyPressEvent(event);
}

void TextButton::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) updateGeometry();
  QAbstractButton::changeEvent(event);
}

}  // namespace boxprobe
