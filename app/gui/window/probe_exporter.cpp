#include "app/gui/window/probe_exporter.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMetaObject>
#include <QStringList>
#include <exception>
#include <utility>
#include <vector>

#include "filters/core/scene/document.h"
#include "filters/io/engines/engine_files.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

/// The first of a space-separated list.
std::string firstWord(std::string_view list) {
  return std::string(list.substr(0, list.find(' ')));
}

/// What each engine is given: its name, and the settings that its file reads.
std::vector<std::pair<QString, ExportSettings>> engineChoices() {
  std::vector<std::pair<QString, ExportSettings>> choices;
  for (const EngineRow& row : engineRows()) {
    const QString name = QString::fromUtf8(row.engine.data(), static_cast<int>(row.engine.size()));
    if (!choices.empty() && choices.back().first == name) continue;
    ExportSettings settings;
    settings.format = firstWord(row.formats);
    settings.ladder = firstWord(row.ladders);
    settings.center = row.centered;
    settings.writer = "Boxprobe " BOXPROBE_VERSION;
    choices.emplace_back(name, settings);
  }
  return choices;
}

}  // namespace

ProbeExporter::ProbeExporter(const Document& document, SceneRenderer& renderer, QWidget* window)
    : QObject(window), document_(document), renderer_(renderer), window_(window) {}

ProbeExporter::~ProbeExporter() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void ProbeExporter::ask() {
  if (running_) return;
  const auto choices = engineChoices();
  QStringList names;
  for (const auto& [name, ignored] : choices) names << name;
  bool chosen = false;
  const QString name = QInputDialog::getItem(window_, tr("Export probes"), tr("For"), names, 0, false, &chosen);
  if (!chosen) return;
  const QString scene = QString::fromStdString(document_.path());
  const QString folder = QFileDialog::getExistingDirectory(window_, tr("Export probes to a folder"),
                                                           scene.isEmpty() ? QString() : QFileInfo(scene).path());
  if (!folder.isEmpty()) start(choices[static_cast<std::size_t>(names.indexOf(name))].second, folder);
}

void ProbeExporter::start(const ExportSettings& settings, const QString& folder) {
  if (running_) return;
  emit ownSceneWanted();
  std::vector<ProbeCapture> captures;
  QStringList unfinished;
  for (const Probe& probe : document_.scene().probes) {
    const auto maps =
        renderer_.bakeState(probe.name) == BakeState::UpToDate ? renderer_.mapsOnCpu(probe.name) : nullptr;
    if (maps == nullptr) {
      unfinished << QString::fromStdString(probe.name);
      continue;
    }
    captures.push_back({probe, maps->radiance, maps->irradiance, maps->capturedRotation, false});
  }
  if (captures.empty()) {
    emit failed(tr("No probe has a finished capture to export; bake first (F5)"));
    return;
  }
  if (thread_.joinable()) thread_.join();
  running_ = true;
  emit message(tr("Exporting %1 probe(s)").arg(captures.size()));
  const QString left = unfinished.isEmpty() ? QString() : tr("; not finished: %1").arg(unfinished.join(", "));
  thread_ = std::thread([this, captures = std::move(captures), settings, folder, left] {
    QString text;
    bool good = true;
    try {
      const auto files = exportProbes(captures, settings, folder.toStdString(), [this](double) { return !stop_; });
      text = tr("Wrote %1 files to %2").arg(files.size()).arg(folder) + left;
      good = left.isEmpty();
    } catch (const std::exception& error) {
      text = QString::fromUtf8(error.what());
      good = false;
    }
    QMetaObject::invokeMethod(
        this, [this, text, good] { end(text, good); }, Qt::QueuedConnection);
  });
}

void ProbeExporter::end(const QString& text, bool good) {
  running_ = false;
  good ? emit message(text) : emit failed(text);
}

}  // namespace boxprobe
