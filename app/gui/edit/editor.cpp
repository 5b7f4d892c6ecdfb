// See editor.h.
#include "app/gui/edit/editor.h"

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

Document::Edit onProbe(const std::string& name, const Editor::ProbeEdit& edit) {
  return [name, edit](Scene& scene) {
    if (const auto index = findProbe(scene, name)) edit(scene.probes[*index]);
  };
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

void Editor::undo() {
  finish();
  guarded([&] { document_.undo(); });
  emit settled();
}

void Editor::redo() {
  finish();
  guarded([&] { document_.redo(); });
  emit settled();
}

void Editor::selectProbe(std::optional<std::size_t> index) {
  finish();
  document_.selectProbe(index);
}

}  // namespace boxprobe
