// See pixel_inspector.h.
#include "app/gui/explain/pixel_inspector.h"

#include <utility>

namespace boxprobe {

PixelInspector::PixelInspector(Hooks hooks, QObject* parent) : QObject(parent), hooks_(std::move(hooks)) {
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &PixelInspector::update);
}

void PixelInspector::setTool(bool on) {
  if (tool_ == on) return;
  tool_ = on;
  if (!on) {
    unpin();
    emit nothingExplained();
  }
  invalidate();
}

void PixelInspector::setReadout(bool on) {
  readout_ = on;
  if (!on) emit readoutEnded();
  invalidate();
}

void PixelInspector::pointerMoved(const QPointF& position) {
  pointer_ = position;
  inside_ = true;
  cameraMoved();
}

void PixelInspector::pointerLeft() {
  inside_ = false;
  if (readout_) emit readoutEnded();
}

void PixelInspector::click(const QPointF& position) {
  if (!tool_ || !hooks_.ready()) return;
  pin_ = hooks_.hold(position);
  pinStale_ = false;
  emit pinChanged(true);
  const Explanation e = explain(pin_);
  emit clicked(e);
  emit explained(e);
}

void PixelInspector::unpin() {
  if (!pin_) return;
  pin_ = {};
  emit pinChanged(false);
  invalidate();
}

void PixelInspector::invalidate() {
  if (!wanted()) return;
  pointerStale_ = pinStale_ = true;
  schedule();
}

void PixelInspector::cameraMoved() {
  if (!readout_ && (!tool_ || pin_)) return;
  pointerStale_ = true;
  schedule();
}

void PixelInspector::schedule() {
  if (!timer_.isActive()) timer_.start();
}

Explanation PixelInspector::explain(const Explain& how) {
  ++count_;
  return how();
}

void PixelInspector::update() {
  if ((!pointerStale_ && !pinStale_) || !hooks_.ready()) return;
  timer_.stop();
  const bool number = readout_ && inside_;
  const bool pointer = std::exchange(pointerStale_, false) && pointer_ && (number || (tool_ && !pin_));
  const bool pin = std::exchange(pinStale_, false) && tool_ && pin_;
  if (pointer) {
    const Explanation under = explain([this] { return hooks_.explain(*pointer_); });
    if (number) emit readout(under, *pointer_);
    if (tool_ && !pin_) emit explained(under);
  }
  if (pin) emit explained(explain(pin_));
}

}  // namespace boxprobe
