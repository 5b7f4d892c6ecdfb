// See scrub_label.h.
#include "app/gui/widgets/scrub_label.h"

#include <QMouseEvent>
#include <algorithm>

#include "app/gui/widgets/pointer_place.h"
#include "app/gui/widgets/value_field.h"

namespace boxprobe {

namespace {

constexpr double kStepsPerPixel = 0.1;
constexpr double kFineStepsPerPixel = 0.01;

}  // namespace

ScrubLabel::ScrubLabel(const QString& text, ValueField* field, QWidget* parent) : QLabel(text, parent), field_(field) {
  setCursor(Qt::SizeHorCursor);
}

void ScrubLabel::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !field_->isEnabled()) return;
  field_->setFocus();
  dragging_ = true;
  lastX_ = pointerOnScreen(*event).x();
  value_ = field_->value();
}

void ScrubLabel::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) return;
  const double x = pointerOnScreen(*event).x();
  const double perPixel = event->modifiers().testFlag(Qt::ShiftModifier) ? kFineStepsPerPixel : kStepsPerPixel;
  value_ = std::clamp(value_ + (x - lastX_) * perPixel * field_->singleStep(), field_->minimum(), field_->maximum());
  lastX_ = x;
  field_->scrubTo(value_);
}

void ScrubLabel::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !dragging_) return;
  dragging_ = false;
  field_->endScrub();
}

}  // namespace boxprobe
