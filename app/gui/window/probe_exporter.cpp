#include "app/gui/window/probe_exporter.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMetaObject>
#include <QStringList>
#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "app/gui/view/workspace.h"
#include "app/session/program_name.h"
#include "filters/core/base/errors.h"
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
    settings.writer = kProgramName;
    choices.emplace_back(name, settings);
  }
  return choices;
}

}  // namespace

ProbeExporter::ProbeExporter(Workspace& workspace, QWidget* window)
    : QObject(window),
      workspace_(workspace),
      document_(workspace.document()),
      renderer_(workspace.renderer()),
      window_(window) {
  workspace.listenTo(this);
  connect(workspace.actions().exportProbes, &QAction::triggered, this, &ProbeExporter::ask);
  turn_.setInterval(0);
  connect(&turn_, &QTimer::timeout, this, &ProbeExporter::readOne);
}

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
  emit workspace_.documentSceneWanted();
  renderer_.sharpenMirrors(0);  // what is exported is of the scene's own size
  captures_.clear();
  unfinished_.clear();
  const auto& probes = document_.scene().probes;
  waiting_.clear();
  for (auto probe = probes.rbegin(); probe != probes.rend(); ++probe) waiting_.push_back(probe->name);
  scene_ = {document_.path(), document_.scene().models};
  const bool any = std::any_of(probes.begin(), probes.end(), [this](const Probe& probe) {
    return renderer_.bakeState(probe.name) == BakeState::UpToDate;
  });
  if (!any) {
    emit failed(tr("No probe has a finished capture to export; bake first (F5)"));
    return;
  }
  settings_ = settings;
  folder_ = folder;
  running_ = true;
  emit message(waiting_.size() == 1 ? tr("Exporting 1 probe") : tr("Exporting %1 probes").arg(waiting_.size()));
  turn_.start();
}

void ProbeExporter::readOne() {
  try {
    emit workspace_.documentSceneWanted();
    if (scene_ != std::make_pair(document_.path(), document_.scene().models)) {
      turn_.stop();
      return end(tr("Not exported: another scene was opened meanwhile"), false);
    }
    if (!waiting_.empty()) return readNext();
    turn_.stop();
    write();
  } catch (const std::exception& error) {
    turn_.stop();
    end(QString::fromStdString(messageOf(error)), false);
  }
}

// The probe as it is in the turn that reads its maps, so that both belong together.
void ProbeExporter::readNext() {
  const std::string& name = waiting_.back();
  const bool finished = renderer_.bakeState(name) == BakeState::UpToDate;
  if (finished && renderer_.filterMissingLevel(name)) return;
  const auto maps = finished ? renderer_.mapsOnCpu(name) : nullptr;
  const std::optional<std::size_t> place = findProbe(document_.scene(), name);
  if (maps && place) {
    captures_.push_back(
        {document_.scene().probes[*place], maps->radiance, maps->irradiance, maps->capturedRotation, false});
  } else {
    unfinished_ << QString::fromStdString(name);
  }
  waiting_.pop_back();
}

void ProbeExporter::write() {
  if (captures_.empty()) return end(tr("No probe has a finished capture to export; bake first (F5)"), false);
  if (thread_.joinable()) thread_.join();  // it ended before
  const QString left = unfinished_.isEmpty() ? QString() : tr("; not finished: %1").arg(unfinished_.join(", "));
  thread_ = std::thread([this, captures = std::move(captures_), settings = settings_, folder = folder_, left] {
    QString text;
    bool good = true;
    try {
      const auto files = exportProbes(captures, settings, folder.toStdString(), [this](double) { return !stop_; });
      text = (files.size() == 1 ? tr("Wrote 1 file to %1").arg(folder)
                                : tr("Wrote %1 files to %2").arg(files.size()).arg(folder)) +
             left;
      good = left.isEmpty();
    } catch (const std::exception& error) {
      text = QString::fromStdString(messageOf(error));
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
