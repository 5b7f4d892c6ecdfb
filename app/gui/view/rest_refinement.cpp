// See rest_refinement.h.
#include "app/gui/view/rest_refinement.h"

#include <utility>

#include "app/gui/widgets/preferences.h"

namespace boxprobe {

RestRefinement::RestRefinement(Hooks hooks, QObject* parent)
    : QObject(parent), hooks_(std::move(hooks)), enabled_(refinesAtRest()) {
  resting_.setSingleShot(true);
  resting_.setInterval(kRestMilliseconds);
  connect(&resting_, &QTimer::timeout, this, &RestRefinement::rested);
}

void RestRefinement::stop() {
  resting_.stop();
  if (!active_) return;
  active_ = false;
  hooks_.setRefined(false);
}

void RestRefinement::setEnabled(bool enabled) {
  if (enabled == enabled_) return;
  enabled_ = enabled;
  keepRefinesAtRest(enabled);
  if (enabled) {
    resting_.start();
  } else {
    stop();
    emit switched();
  }
  emit enabledChanged(enabled);
}

void RestRefinement::moved() {
  stop();
  if (enabled_) resting_.start();
}

void RestRefinement::setRest(int milliseconds) {
  resting_.setInterval(milliseconds);  // begins anew if it runs
}

void RestRefinement::rested() {
  if (!enabled_ || active_ || !hooks_.everRests()) return;
  if (!hooks_.resting()) {
    resting_.start();
    return;
  }
  active_ = true;
  hooks_.setRefined(true);
  emit switched();
}

}  // namespace boxprobe
