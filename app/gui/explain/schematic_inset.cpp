// See schematic_inset.h.
#include "app/gui/explain/schematic_inset.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "app/gui/explain/schematic_painter.h"

namespace boxprobe {

namespace {

constexpr int kInsetMargin = 10;
/// Of the picture's width, within what is legible and what is needed; logical pixels.
constexpr double kShareOfWidth = 0.45;
constexpr int kSmallestWidth = 380, kLargestWidth = 620;
constexpr double kLargestShareOfHeight = 0.45;

}  // namespace

SchematicInset::SchematicInset(QWidget* parent) : QWidget(parent) {
  setObjectName("schematic");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  parent->installEventFilter(this);
  hide();
}

SchematicInset::SchematicInset(InLayout) : inPicture_(false) {
  setObjectName("plan");
  hide();
}

void SchematicInset::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!inPicture_) setFixedHeight(width() / 2);
}

void SchematicInset::show(const Explanation& explanation, const QPointF& position) {
  if (!shown_) return;
  position_ = position;
  schematic_ = schematic(explanation);
  setVisible(schematic_.has_value());
  if (inPicture_) place();
  update();
}

void SchematicInset::clear() {
  schematic_.reset();
  hide();
}

void SchematicInset::setShown(bool shown) {
  shown_ = shown;
  if (!shown) clear();
}

void SchematicInset::place() {
  const QSize room = parentWidget()->size();
  const int wanted = std::clamp(static_cast<int>(kShareOfWidth * room.width()), kSmallestWidth, kLargestWidth);
  const int width = std::min(wanted, room.width() - 2 * kInsetMargin);
  const int height = std::min(width / 2, static_cast<int>(kLargestShareOfHeight * room.height()));
  QRect place(room.width() - width - kInsetMargin, room.height() - height - kInsetMargin, width, height);
  if (place.adjusted(-kInsetMargin, -kInsetMargin, kInsetMargin, kInsetMargin).contains(position_.toPoint()))
    place.moveTop(kInsetMargin);
  setGeometry(place);
}

void SchematicInset::paintEvent(QPaintEvent*) {
  if (!schematic_) return;
  QPainter painter(this);
  paintSchematic(painter, QRectF(rect()), *schematic_);
}

bool SchematicInset::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

}  // namespace boxprobe
