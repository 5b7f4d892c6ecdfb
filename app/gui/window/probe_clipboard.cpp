// See probe_clipboard.h.
#include "app/gui/window/probe_clipboard.h"

#include <QApplication>
#include <QClipboard>

#include "app/gui/edit/probe_copies.h"
#include "app/gui/view/workspace.h"
#include "filters/core/base/errors.h"
#include "filters/io/json/json_text.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace {

constexpr const char* kName = "clipboard";
/// Pictures of custom probes are written with their whole path: the text may be pasted into a scene elsewhere.
constexpr const char* kFolder = "/";

}  // namespace

std::vector<Probe> probesFromText(const std::string& text) {
  const JsonText json = parseJsonText(text, kName);
  std::string scene = text;
  if (json.root.is_array()) {
    scene = "{\"format\": \"boxprobe-scene\", \"version\": 1, \"probes\": " + text + "}";
  } else if (json.root.is_object() && !json.root.contains("format") && !json.root.contains("probes")) {
    scene = "{\"format\": \"boxprobe-scene\", \"version\": 1, \"probes\": [" + text + "]}";
  } else if (json.root.is_object() && !json.root.contains("format")) {
    scene = "{\"format\": \"boxprobe-scene\", \"version\": 1, " + text.substr(text.find('{') + 1);
  }
  const std::vector<Probe> probes = parseScene(scene, kName, kFolder).probes;
  if (probes.empty()) throw InputError(std::string(kName) + ": a scene without probes");
  return probes;
}

ProbeClipboard::ProbeClipboard(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace), editor_(workspace.editor()) {
  connect(workspace.actions().copy, &QAction::triggered, this, &ProbeClipboard::copy);
  connect(workspace.actions().paste, &QAction::triggered, this, &ProbeClipboard::paste);
}

void ProbeClipboard::copy() {
  editor_.finish();
  const std::vector<std::size_t> selected = editor_.selected();
  if (selected.empty()) return;
  Scene alone;
  for (const std::size_t index : selected) alone.probes.push_back(editor_.scene().probes[index]);
  QApplication::clipboard()->setText(QString::fromStdString(sceneText(alone, kFolder)));
  emit workspace_.message(selected.size() == 1 ? tr("Copied probe %1 as JSON").arg(editor_.selectedName())
                                               : tr("Copied %1 as JSON").arg(editor_.selectedName()));
}

void ProbeClipboard::paste() {
  editor_.finish();
  const std::string text = QApplication::clipboard()->text().toStdString();
  std::vector<Probe> probes;
  try {
    if (text.empty()) throw InputError("it holds no text");
    probes = probesFromText(text);
  } catch (const Error& error) {
    emit workspace_.failed(tr("No probe to paste: %1").arg(QString::fromUtf8(error.what())));
    return;
  }
  std::vector<Probe> all = editor_.scene().probes;
  ProbeCopies copies(editor_.scene());
  for (const Probe& probe : probes) all.push_back(copies.add(probe));
  const QString name = QString::fromStdString(all.back().name);
  editor_.commit(probes.size() == 1 ? tr("Paste %1").arg(name) : tr("Paste %1 probes").arg(probes.size()),
                 [all](Scene& scene) { scene.probes = all; });
  std::vector<std::size_t> pasted;
  for (std::size_t i = all.size() - probes.size(); i < all.size(); ++i) pasted.push_back(i);
  editor_.selectProbes(pasted);
}

}  // namespace boxprobe
