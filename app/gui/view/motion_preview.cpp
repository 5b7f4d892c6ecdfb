// See motion_preview.h.
#include "app/gui/view/motion_preview.h"

#include <utility>

#include "app/gui/widgets/preferences.h"

namespace boxprobe {

MotionPreview::MotionPreview(Hooks hooks, QObject* parent)
    : QObject(parent), hooks_(std::move(hooks)), chosen_(cheaperWhileMoving()) {
  resting_.setSingleShot(true);
  resting_.setInterval(kRestMilliseconds);
  connect(&resting_, &QTimer::timeout, this, &MotionPreview::rest);
}

void MotionPreview::apply(bool enabled) {
  if (enabled == enabled_) return;
  enabled_ = enabled;
  hooks_.allow(enabled);
  if (!enabled) rest();
  emit enabledChanged(enabled);
}

void MotionPreview::setEnabled(bool enabled) {
  if (enabled == enabled_) return;
  chosen_ = enabled;
  keepCheaperWhileMoving(enabled);
  apply(enabled);
}

void MotionPreview::setDefault(bool softwareRenderer) {
  apply(chosen_.value_or(softwareRenderer));
}

void MotionPreview::moved() {
  // Where nothing stands in for anything, there is nothing to come back from.
  active_ = enabled_ && hooks_.setMoving(true);
  if (active_) resting_.start();
}

void MotionPreview::setRest(int milliseconds) {
  resting_.setInterval(milliseconds);  // begins anew if it runs
}

void MotionPreview::rest() {
  if (!active_) return;
  active_ = false;
  resting_.stop();
  hooks_.setMoving(false);
  emit cameToRest();
}

}  // namespace boxprobe
