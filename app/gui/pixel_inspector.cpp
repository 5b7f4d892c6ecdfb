// See pixel_inspector.h.
#include "app/gui/pixel_inspector.h"

#include <glm/geometric.hpp>
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
  invalidate();
}

void PixelInspector::pointerLeft() {
  pointer_.reset();
  if (!wanted()) return;
  emit readoutEnded();
  if (!pin_) emit nothingExplained();
}

void PixelInspector::click(const QPointF& position) {
  if (!tool_ || !hooks_.ready()) return;
  pointer_ = position;
  const Explanation e = explain(position);
  pin_ = Pin{position, e.hit ? std::optional(e.surface.positionWorld) : std::nullopt};
  emit pinChanged(true);
  emit clicked(e);
  invalidate();
}

void PixelInspector::unpin() {
  if (!pin_) return;
  pin_.reset();
  emit pinChanged(false);
  invalidate();
}

void PixelInspector::invalidate() {
  if (!wanted() || (!pointer_ && !pin_)) return;
  stale_ = true;
  if (!timer_.isActive()) timer_.start();
}

std::optional<QPointF> PixelInspector::pinPosition() const {
  return pin_->pointWorld ? hooks_.logicalPosition(*pin_->pointWorld) : pin_->position;
}

Explanation PixelInspector::explain(const QPointF& position) {
  ++count_;
  return hooks_.explain(position);
}

void PixelInspector::update() {
  if (!stale_ || !hooks_.ready()) return;
  stale_ = false;
  timer_.stop();
  std::optional<Explanation> under;
  if (pointer_ && (readout_ || !pin_)) {
    under = explain(*pointer_);
    if (readout_) emit readout(*under, *pointer_);
  }
  if (!tool_) return;
  if (!pin_) {
    if (under) emit explained(*under);
    return;
  }
  const auto position = pinPosition();
  if (!position) return;  // out of view: the card keeps what it said last
  Explanation e = under && *position == *pointer_ ? *under : explain(*position);
  if (pin_->pointWorld && e.hit) {
    // A pixel's width on the surface is no error; another surface in front is.
    const double away = glm::length(e.surface.positionWorld - *pin_->pointWorld);
    const double distance = glm::length(*pin_->pointWorld - e.surface.eyeWorld);
    constexpr double kHidden = 0.03;
    if (away > kHidden * distance) {
      e.notes.insert(e.notes.begin(), "The pinned point is hidden from here: this is the surface in front of it.");
    }
  }
  emit explained(e);
}

}  // namespace boxprobe
