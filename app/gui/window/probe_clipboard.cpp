// See probe_clipboard.h.
#include "app/gui/window/probe_clipboard.h"

#include <QApplication>
#include <QClipboard>

#include "app/gui/handles/handle_drag.h"
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

ProbeClipboard::ProbeClipboard(Editor& editor, QObject* parent) : QObject(parent), editor_(editor) {}

void ProbeClipboard::copy() {
  editor_.finish();
  const Probe* probe = editor_.probe();
  if (probe == nullptr) return;
  Scene alone;
  alone.probes = {*probe};
  QApplication::clipboard()->setText(QString::fromStdString(sceneText(alone, kFolder)));
  emit message(tr("Copied probe %1 as JSON").arg(QString::fromStdString(probe->name)));
}

void ProbeClipboard::paste() {
  editor_.finish();
  const std::string text = QApplication::clipboard()->text().toStdString();
  std::vector<Probe> probes;
  try {
    if (text.empty()) throw InputError("it holds no text");
    probes = probesFromText(text);
  } catch (const Error& error) {
    emit failed(tr("No probe to paste: %1").arg(QString::fromUtf8(error.what())));
    return;
  }
  Scene after = editor_.scene();
  for (Probe probe : probes) {
    probe = besideOthers(probe, after.probes);
    if (findProbe(after, probe.name)) probe.name = unusedProbeName(after, probe.name);
    after.probes.push_back(probe);
  }
  const std::vector<Probe> all = after.probes;
  const QString name = QString::fromStdString(all.back().name);
  editor_.commit(probes.size() == 1 ? tr("Paste %1").arg(name) : tr("Paste %1 probes").arg(probes.size()),
                 [all](Scene& scene) { scene.probes = all; });
  editor_.selectProbe(findProbe(editor_.scene(), all.back().name));
}

}  // namespace boxprobe
