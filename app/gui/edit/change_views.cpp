// See change_views.h.
#include "app/gui/edit/change_views.h"

#include <algorithm>
#include <utility>

namespace boxprobe {

ChangeKinds ChangeKinds::all() {
  ChangeKinds kinds({});
  kinds.all_ = true;
  return kinds;
}

bool ChangeKinds::anyIn(const Changes& changes) const {
  if (all_) return changes.any();
  return std::any_of(kinds_.begin(), kinds_.end(), [&](Kind kind) { return changes.*kind; });
}

ChangeKinds selectedProbeKinds() {
  return {&Changes::probeShape, &Changes::probeTechnique, &Changes::probeCapture, &Changes::probeList,
          &Changes::selection};
}

ChangeViews::~ChangeViews() {
  for (const auto& view : views_) document_.removeObserver(view->observer);
}

void ChangeViews::View::tell(const Changes& changes) {
  if (!kinds.anyIn(changes)) return;
  ++updates;
  update(changes);
}

void ChangeViews::add(std::string name, ChangeKinds kinds, Update update) {
  views_.push_back(std::make_unique<View>(View{std::move(name), std::move(kinds), std::move(update)}));
  View* view = views_.back().get();
  view->observer = document_.addObserver([view](const Changes& changes) { view->tell(changes); });
}

void ChangeViews::updateAll() {
  for (const auto& view : views_) view->tell(Changes::all());
}

std::size_t ChangeViews::updates(const std::string& name) const {
  const auto found = std::find_if(views_.begin(), views_.end(), [&](const auto& view) { return view->name == name; });
  return found == views_.end() ? 0 : (*found)->updates;
}

}  // namespace boxprobe
