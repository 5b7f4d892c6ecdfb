// See editor.h.
#include "app/gui/edit/editor.h"

#include <algorithm>
#include <string>
#include <vector>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

Document::Edit onProbe(const std::string& name, const Editor::ProbeEdit& edit) {
  return [name, edit](Scene& scene) {
    if (const auto index = findProbe(scene, name)) edit(scene.probes[*index]);
  };
}

std::vector<std::string> probeNames(const Scene& scene) {
  std::vector<std::string> names;
  for (const Probe& probe : scene.probes) names.push_back(probe.name);
  return names;
}

}  // namespace

Editor::Editor(Document& document, QObject* parent) : QObject(parent), document_(document) {}

template <typename Work>
void Editor::guarded(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    if (document_.previewing()) document_.cancel();
    forgetPending();
    emit failed(QString::fromUtf8(error.what()));
  }
}

const Probe* Editor::probe() const {
  const auto index = document_.selectedProbe();
  return index ? &document_.scene().probes[*index] : nullptr;
}

std::vector<std::size_t> Editor::selected() const {
  const auto shown = document_.selectedProbe();
  if (!shown) return {};
  const auto& probes = scene().probes;
  if (together_.count(probes[*shown].name) == 0) return {*shown};
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (together_.count(probes[i].name) > 0) indices.push_back(i);
  }
  return indices;
}

QString Editor::selectedName() const {
  const std::size_t count = selected().size();
  if (count > 1) return tr("%1 probes").arg(count);
  return count == 1 ? QString::fromStdString(probe()->name) : QString();
}

bool Editor::goesOn(const EditToken& token) const {
  return token.control != nullptr && token == pending_;
}

void Editor::forgetPending() {
  pending_ = {};
  pendingLabel_.clear();
}

void Editor::preview(const EditToken& token, const QString& label, const Document::Edit& edit) {
  if (!goesOn(token)) finish();
  guarded([&] {
    pending_ = token;
    pendingLabel_ = label;
    document_.preview(edit);
  });
}

void Editor::commit(const EditToken& token, const QString& label, const Document::Edit& edit) {
  if (!goesOn(token)) finish();
  forgetPending();
  const std::vector<std::size_t> selectedBefore = selected();
  const std::vector<std::string> names = probeNames(scene());
  guarded([&] { document_.commit(label.toStdString(), edit); });
  const bool renamed = followRenames(names);
  if (renamed || selected() != selectedBefore) emit selectionChanged();
  emit settled();
}

Document::Edit Editor::onSelected(const ProbeEdit& edit) const {
  const std::vector<std::size_t> indices = selected();
  if (indices.size() == 1) return onProbe(probe()->name, edit);
  std::set<std::string> names;
  for (const std::size_t index : indices) names.insert(scene().probes[index].name);
  return [names, edit](Scene& scene) {
    for (Probe& probe : scene.probes) {
      if (names.count(probe.name) > 0) edit(probe);
    }
  };
}

void Editor::previewProbe(EditToken token, const QString& label, const ProbeEdit& edit) {
  const Probe* shown = probe();
  if (shown == nullptr) return;
  token.target = shown->name;
  preview(token, label, onSelected(edit));
}

void Editor::commitProbe(EditToken token, const QString& label, const ProbeEdit& edit) {
  const Probe* shown = probe();
  if (shown == nullptr) return;
  token.target = shown->name;
  commit(token, label, onSelected(edit));
}

void Editor::commitOne(const QString& label, const ProbeEdit& edit) {
  if (const Probe* shown = probe()) commit(label, onProbe(shown->name, edit));
}

void Editor::finish() {
  const QString label = pendingLabel_;
  forgetPending();
  if (!document_.previewing()) return;
  guarded([&] { document_.commitPreview(label.toStdString()); });
  emit settled();
}

void Editor::cancel() {
  forgetPending();
  if (document_.previewing()) document_.cancel();
  emit settled();
}

template <typename Move>
void Editor::step(const Move& move) {
  finish();
  const std::vector<std::string> names = probeNames(scene());
  const std::vector<std::size_t> allBefore = selected();
  const auto selectedBefore = document_.selectedProbe();
  guarded(move);
  const bool renamed = followRenames(names);
  const auto& probes = scene().probes;
  if (probes.size() > names.size()) {
    selectWhatCameBack(names);
  } else if (selectedBefore && !document_.selectedProbe() && !probes.empty()) {
    selectProbe(std::min(*selectedBefore > 0 ? *selectedBefore - 1 : 0, probes.size() - 1));
  }
  if (renamed || selected() != allBefore) emit selectionChanged();
  emit settled();
}

// A renamed probe keeps its place, and no other has the name that it had. True if one of those selected was: whoever
// heard of the edit before saw it alone.
bool Editor::followRenames(const std::vector<std::string>& before) {
  const auto& probes = scene().probes;
  if (probes.size() != before.size()) return false;
  std::set<std::string> after;
  bool any = false;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const bool renamed = probes[i].name != before[i] && !findProbe(scene(), before[i]);
    if (together_.count(before[i]) == 0) continue;
    after.insert(renamed ? probes[i].name : before[i]);
    any |= renamed;
  }
  together_ = after;
  return any;
}

void Editor::selectWhatCameBack(const std::vector<std::string>& names) {
  const std::set<std::string> before(names.begin(), names.end());
  std::vector<std::size_t> back;
  const auto& probes = scene().probes;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (before.count(probes[i].name) == 0) back.push_back(i);
  }
  // Where others went meanwhile, nobody knows which of them counts.
  if (back.size() + before.size() == probes.size()) selectProbes(back);
}

void Editor::undo() {
  step([this] { document_.undo(); });
}

void Editor::redo() {
  step([this] { document_.redo(); });
}

void Editor::goTo(std::size_t position) {
  step([this, position] { document_.goTo(position); });
}

void Editor::selectProbe(std::optional<std::size_t> index) {
  selectProbes(index ? std::vector<std::size_t>{*index} : std::vector<std::size_t>(), index);
}

void Editor::selectProbes(const std::vector<std::size_t>& indices, std::optional<std::size_t> shown) {
  finish();
  const std::vector<std::size_t> before = selected();
  const auto& probes = scene().probes;
  if (!shown || std::find(indices.begin(), indices.end(), *shown) == indices.end()) {
    shown = indices.empty() ? std::nullopt : std::optional<std::size_t>(indices.back());
  }
  together_.clear();
  for (const std::size_t index : indices) {
    if (index < probes.size()) together_.insert(probes[index].name);
  }
  const auto shownBefore = document_.selectedProbe();
  document_.selectProbe(shown);
  if (shownBefore != document_.selectedProbe() || before != selected()) emit selectionChanged();
  if (!indices.empty()) emit probesAsked();
}

void Editor::toggleProbe(std::size_t index) {
  std::vector<std::size_t> indices = selected();
  const auto found = std::find(indices.begin(), indices.end(), index);
  if (found == indices.end()) {
    indices.push_back(index);
    return selectProbes(indices, index);
  }
  if (indices.size() == 1) return;
  indices.erase(found);
  selectProbes(indices, document_.selectedProbe());
}

}  // namespace boxprobe
