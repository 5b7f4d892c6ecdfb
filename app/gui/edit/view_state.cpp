// See view_state.h.
#include "app/gui/edit/view_state.h"

#include <algorithm>
#include <iterator>

namespace boxprobe {

ViewState::ViewState(QObject* parent) : QObject(parent) {}

void ViewState::selectObjects(const Names& nodes) {
  if (nodes == objects_) return;
  objects_ = nodes;
  emit changed();
}

bool ViewState::hidden(Part part, const std::string& name) const {
  return hidden_.of(part).count(name) > 0;
}

bool ViewState::shown(Part part, const std::string& name) const {
  return isolated_ ? isolated_->of(part).count(name) > 0 : !hidden(part, name);
}

bool ViewState::locked(Part part, const std::string& name) const {
  return locked_.of(part).count(name) > 0;
}

void ViewState::set(Names& names, const Names& which, bool on) {
  const Names before = names;
  for (const std::string& name : which) on ? void(names.insert(name)) : void(names.erase(name));
  if (names != before) emit changed();
}

void ViewState::setHidden(Part part, const Names& names, bool hidden) {
  set(hidden_.of(part), names, hidden);
}

void ViewState::setLocked(Part part, const Names& names, bool locked) {
  set(locked_.of(part), names, locked);
}

void ViewState::isolate(const Names& probes, const Names& objects) {
  const Marks wanted{probes, objects};
  if (isolated_ && *isolated_ == wanted) return;
  isolated_ = wanted;
  emit changed();
}

void ViewState::endIsolation() {
  if (!isolated_) return;
  isolated_.reset();
  emit changed();
}

void ViewState::showAll() {
  if (!isolated_ && !anyHidden()) return;
  isolated_.reset();
  hidden_ = {};
  emit changed();
}

bool ViewState::anyHidden() const {
  return !(hidden_ == Marks{});
}

void ViewState::setCutaway(bool on) {
  if (on == cutaway_) return;
  cutaway_ = on;
  emit changed();
}

std::vector<ViewState::Names*> ViewState::everything(Part part) {
  std::vector<Names*> all{&hidden_.of(part), &locked_.of(part)};
  if (isolated_) all.push_back(&isolated_->of(part));
  if (part == Part::Object) all.push_back(&objects_);
  return all;
}

void ViewState::follow(const std::vector<Probe>& probes, const Names& nodes) {
  std::vector<std::string> now;
  now.reserve(probes.size());
  for (const Probe& probe : probes) now.push_back(probe.name);
  const Names left(now.begin(), now.end()), before(probeNames_.begin(), probeNames_.end());
  bool any = false;
  for (Names* names : everything(Part::Probe)) {
    const Names was = *names;
    // A renamed probe keeps its place, and no other has the name that it had.
    for (std::size_t i = 0; now.size() == probeNames_.size() && i < now.size(); ++i) {
      const bool renamed = now[i] != probeNames_[i] && left.count(probeNames_[i]) == 0 && before.count(now[i]) == 0;
      if (renamed && was.count(probeNames_[i]) > 0) names->insert(now[i]);
    }
    for (const std::string& name : was) {
      if (left.count(name) == 0) names->erase(name);
    }
    any |= *names != was;
  }
  for (Names* names : everything(Part::Object)) {
    const Names was = *names;
    names->clear();
    std::set_intersection(was.begin(), was.end(), nodes.begin(), nodes.end(), std::inserter(*names, names->end()));
    any |= *names != was;
  }
  probeNames_ = std::move(now);
  if (any) emit changed();
}

void ViewState::forget() {
  const bool any = isolated_ || anyHidden() || anyLocked() || !objects_.empty();
  objects_.clear();
  hidden_ = locked_ = {};
  isolated_.reset();
  probeNames_.clear();
  if (any) emit changed();
}

}  // namespace boxprobe
