// See schematic_inset.h.
#include "app/gui/schematic_inset.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "app/gui/schematic_painter.h"

namespace boxprobe {

namespace {

constexpr int kMargin = 10;
constexpr int kWidth = 600, kHeight = 300;  ///< logical pixels; less in a small picture
constexpr double kLargestShare = 0.75;      ///< of the picture's width
constexpr double kLargestHeightShare = 0.5;

}  // namespace

SchematicInset::SchematicInset(QWidget* parent) : QWidget(parent) {
  setObjectName("schematic");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  parent->installEventFilter(this);
  hide();
}

void SchematicInset::show(const Explanation& explanation) {
  if (!shown_) return;
  schematic_ = schematic(explanation);
  setVisible(schematic_.has_value());
  place();
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
  const int width = std::min(kWidth, static_cast<int>(kLargestShare * room.width()));
  const int height = std::min(kHeight, static_cast<int>(kLargestHeightShare * room.height()));
  setGeometry(room.width() - width - kMargin, room.height() - height - kMargin, width, height);
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
