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

/// After undo or redo: a probe that came back, or the neighbour of the selected one that went.
void selectWhatChanged(Document& document, const std::vector<std::string>& before,
                       std::optional<std::size_t> selected) {
  const auto& probes = document.scene().probes;
  if (probes.size() == before.size() + 1) {
    for (std::size_t i = 0; i < probes.size(); ++i) {
      if (std::find(before.begin(), before.end(), probes[i].name) == before.end()) document.selectProbe(i);
    }
  } else if (selected && !document.selectedProbe() && !probes.empty()) {
    document.selectProbe(std::min(*selected > 0 ? *selected - 1 : 0, probes.size() - 1));
  }
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
  guarded([&] { document_.commit(label.toStdString(), edit); });
  emit settled();
}

void Editor::previewProbe(EditToken token, const QString& label, const ProbeEdit& edit) {
  const Probe* selected = probe();
  if (selected == nullptr) return;
  token.target = selected->name;
  preview(token, label, onProbe(selected->name, edit));
}

void Editor::commitProbe(EditToken token, const QString& label, const ProbeEdit& edit) {
  const Probe* selected = probe();
  if (selected == nullptr) return;
  token.target = selected->name;
  commit(token, label, onProbe(selected->name, edit));
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
  const auto names = probeNames(scene());
  const auto selected = document_.selectedProbe();
  guarded(move);
  selectWhatChanged(document_, names, selected);
  emit settled();
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
  finish();
  document_.selectProbe(index);
}

}  // namespace boxprobe
