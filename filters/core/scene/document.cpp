// Undo by snapshots: a step shares the scenes before and after it, so it costs one copy of the scene and undo always
// restores exactly what was shown. All state changes go through move(), which notifies last.
#include "filters/core/scene/document.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

using Snapshot = std::shared_ptr<const Scene>;

Snapshot edited(const Scene& scene, const Document::Edit& edit) {
  auto copy = std::make_shared<Scene>(scene);
  edit(*copy);
  validate(*copy);
  return copy;
}

bool same(const Snapshot& a, const Snapshot& b) {
  return a == b || *a == *b;
}

/// The name of the selected probe in `after`. If the number of probes is unchanged and the probe at its index has a new
/// name, it was renamed. Otherwise a missing name was a removal, which keeps the old name for undo.
std::string followedName(const Scene& before, const Scene& after, const std::string& name) {
  const auto index = findProbe(before, name);
  if (!index || findProbe(after, name) || before.probes.size() != after.probes.size()) return name;
  const std::string& now = after.probes[*index].name;
  return findProbe(before, now) ? name : now;
}

}  // namespace

Document::State::State() : committed_(std::make_shared<Scene>()), saved_(committed_) {}

Document::State Document::State::opened(Scene scene, std::string path, std::optional<std::string> selectedProbe) {
  validate(scene);
  State state;
  state.committed_ = state.saved_ = std::make_shared<Scene>(std::move(scene));
  state.path_ = std::move(path);
  state.selectedName_ = std::move(selectedProbe);
  return state;
}

Document::Document() : shown_(state_.committed_) {}

void Document::restore(State state, const Changes& also) {
  Changes changes = difference(*shown_, *state.committed_);
  changes |= also;
  changes.file = changes.selection = true;
  state_ = std::move(state);
  shown_ = state_.committed_;
  notify(changes);
}

const Scene& Document::scene() const {
  return *shown_;
}

std::optional<std::size_t> Document::selectedProbe() const {
  if (!state_.selectedName_) return std::nullopt;
  return findProbe(*shown_, *state_.selectedName_);
}

void Document::selectProbe(std::optional<std::size_t> index) {
  std::optional<std::string> name;
  if (index && *index < shown_->probes.size()) name = shown_->probes[*index].name;
  const auto before = selectedProbe();
  state_.selectedName_ = name;
  Changes changes;
  changes.selection = before != selectedProbe();
  if (changes.any()) notify(changes);
}

void Document::open(Scene scene, std::string path, bool unsaved) {
  State state = State::opened(std::move(scene), std::move(path));
  if (unsaved) state.saved_ = nullptr;
  restore(std::move(state), Changes::all());
}

bool Document::preview(const Edit& edit) {
  Snapshot next;
  try {
    next = edited(*state_.committed_, edit);
  } catch (const InputError&) {
    return false;
  }
  move(state_.committed_, std::move(next), state_.position_, {});
  return true;
}

void Document::commit(const std::string& label, const Edit& edit) {
  Snapshot next;
  try {
    next = edited(*state_.committed_, edit);
  } catch (...) {
    cancel();
    throw;
  }
  record(label, next);
}

void Document::commitPreview(const std::string& label) {
  if (previewing()) record(label, shown_);
}

void Document::record(const std::string& label, const Snapshot& scene) {
  if (same(state_.committed_, scene)) {
    cancel();
    return;
  }
  state_.steps_.resize(state_.position_);
  state_.steps_.push_back({label, state_.committed_, scene});
  move(scene, scene, state_.steps_.size(), {});
}

void Document::cancel() {
  move(state_.committed_, state_.committed_, state_.position_, {});
}

bool Document::previewing() const {
  return shown_ != state_.committed_;
}

bool Document::canUndo() const {
  return state_.position_ > 0;
}
bool Document::canRedo() const {
  return state_.position_ < state_.steps_.size();
}
std::string Document::undoLabel() const {
  return canUndo() ? state_.steps_[state_.position_ - 1].label : std::string();
}
std::string Document::redoLabel() const {
  return canRedo() ? state_.steps_[state_.position_].label : std::string();
}

void Document::undo() {
  if (!canUndo()) return cancel();
  const Snapshot target = state_.steps_[state_.position_ - 1].before;
  move(target, target, state_.position_ - 1, {});
}

void Document::redo() {
  if (!canRedo()) return cancel();
  const Snapshot target = state_.steps_[state_.position_].after;
  move(target, target, state_.position_ + 1, {});
}

std::vector<std::string> Document::stepLabels() const {
  std::vector<std::string> labels;
  for (const State::Step& step : state_.steps_) labels.push_back(step.label);
  return labels;
}

std::size_t Document::position() const {
  return state_.position_;
}

void Document::goTo(std::size_t position) {
  const auto& steps = state_.steps_;
  position = std::min(position, steps.size());
  if (position == state_.position_) return cancel();
  const Snapshot target = position == 0 ? steps.front().before : steps[position - 1].after;
  move(target, target, position, {});
}

const std::string& Document::path() const {
  return state_.path_;
}

bool Document::modified() const {
  return state_.saved_ == nullptr || !same(state_.committed_, state_.saved_);
}

void Document::markSaved(std::string path) {
  state_.saved_ = state_.committed_;
  state_.path_ = std::move(path);
  Changes changes;
  changes.file = true;
  notify(changes);
}

std::size_t Document::addObserver(Observer observer) {
  observers_.emplace_back(nextObserver_, std::move(observer));
  return nextObserver_++;
}

void Document::removeObserver(std::size_t id) {
  observers_.erase(std::remove_if(observers_.begin(), observers_.end(), [id](const auto& o) { return o.first == id; }),
                   observers_.end());
}

void Document::move(Snapshot committed, Snapshot shown, std::size_t position, Changes changes) {
  const Snapshot before = shown_;
  const bool modifiedBefore = modified();
  const auto selectedBefore = selectedProbe();
  std::optional<std::string> name = state_.selectedName_;
  if (name) name = followedName(*before, *shown, *name);
  changes |= difference(*before, *shown);

  state_.committed_ = std::move(committed);
  shown_ = std::move(shown);
  state_.position_ = position;
  state_.selectedName_ = std::move(name);
  changes.selection |= selectedBefore != selectedProbe();
  changes.file |= modifiedBefore != modified();
  if (changes.any()) notify(changes);
}

void Document::notify(const Changes& changes) {
  std::vector<std::size_t> ids;
  for (const auto& observer : observers_) ids.push_back(observer.first);
  std::exception_ptr first;
  for (const std::size_t id : ids) {
    const auto found =
        std::find_if(observers_.begin(), observers_.end(), [id](const auto& o) { return o.first == id; });
    if (found == observers_.end()) continue;  // removed by an observer that ran before it
    const Observer observer = found->second;  // a copy: it may remove itself while it runs
    try {
      observer(changes);
    } catch (...) {
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace boxprobe
