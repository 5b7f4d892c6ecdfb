// See live_link.h.
#include "app/gui/window/live_link.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSignalBlocker>
#include <filesystem>
#include <iterator>
#include <utility>

#include "app/gui/view/workspace.h"
#include "app/gui/widgets/message_box.h"
#include "app/session/glb_export.h"
#include "app/session/program_name.h"
#include "filters/core/base/errors.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/files/atomic_file.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

LiveLink::LiveLink(Workspace& workspace, QWidget* window)
    : QObject(window),
      workspace_(workspace),
      document_(workspace.document()),
      renderer_(workspace.renderer()),
      window_(window) {
  constexpr int kSoonMilliseconds = 150;  // several edits in a row are one file
  constexpr int kTurnMilliseconds = 20;
  soon_.setSingleShot(true);
  soon_.setInterval(kSoonMilliseconds);
  turn_.setInterval(kTurnMilliseconds);
  connect(&soon_, &QTimer::timeout, this, &LiveLink::write);
  connect(&turn_, &QTimer::timeout, this, &LiveLink::readOne);
  connect(&work_, &BackgroundWork::ended, this, &LiveLink::written);
  workspace.listenTo(this);
  connect(workspace.actions().liveLink, &QAction::toggled, this, &LiveLink::ask);
  connect(&workspace.editor(), &Editor::settled, this, &LiveLink::changed);
  workspace.changes().add("live link", {&Changes::file, &Changes::models}, [this](const Changes&) { changed(); });
}

void LiveLink::show(bool on) {
  QAction* action = workspace_.actions().liveLink;
  const QSignalBlocker quiet(action);
  action->setChecked(on);
}

void LiveLink::ask(bool on) {
  if (!on) return stop();
  const QString scene = QString::fromStdString(document_.path());
  const QString proposed = scene.isEmpty() ? QString("live.glb") : QFileInfo(scene).path() + "/live.glb";
  QString path = QFileDialog::getSaveFileName(window_, tr("Live link to a file"), proposed, tr("glTF (*.glb)"));
  if (path.isEmpty()) return show(false);
  if (QFileInfo(path).suffix().isEmpty()) {
    path += ".glb";
    if (!mayOverwrite(window_, tr("Live link to a file"), path)) return show(false);
  }
  start(path);
}

void LiveLink::start(const QString& path) {
  for (const ModelFile& model : document_.scene().models) {
    std::error_code ignored;
    if (!std::filesystem::equivalent(model.file, path.toStdString(), ignored)) continue;
    emit failed(tr("%1 is the scene's model; the live link needs a file of its own").arg(path));
    show(false);
    return;
  }
  path_ = path;
  told_.clear();
  maps_.clear();
  writtenHere_ = 0;
  show(true);
  write();
}

void LiveLink::stop() {
  if (!running()) return;
  soon_.stop();
  turn_.stop();
  emit message(writtenHere_ == 1 ? tr("The live link to %1 ended after 1 revision").arg(path_)
                                 : tr("The live link to %1 ended after %2 revisions").arg(path_).arg(writtenHere_));
  path_.clear();
  show(false);
}

void LiveLink::changed() {
  if (running() && !soon_.isActive()) soon_.start();
}

void LiveLink::write() {
  if (!running() || workspace_.lesson() != nullptr) return;
  if (document_.previewing()) return soon_.start();
  const Workspace::Models& models = workspace_.models();
  if (models.empty() || document_.scene().models.size() != models.size()) return;
  if (work_.running()) {
    again_ = true;
    return;
  }
  again_ = mapsNew_ = false;
  auto content = std::make_shared<GlbScene>();
  content->scene = document_.scene();
  content->writer = kProgramName;
  content->diffuse = renderer_.probesDiffuse();
  writing_ = path_;
  work_.start([content, maps = maps_, models, path = path_.toStdString(),
               revision = revision_ + 1](const BackgroundWork::Progress&) -> BackgroundWork::Finish {
    for (const Probe& probe : content->scene.probes) {
      const auto found = maps.find(probe.name);
      content->maps.emplace_back();
      if (found == maps.end()) continue;
      content->maps.back().emplace();
      content->maps.back()->maps = *found->second;
    }
    writeTextAtomically(path, glbWithProbes(*content, models, path));
    writeRevision(path, revision);
    return [] {};
  });
  turn_.start();
}

void LiveLink::written(bool stopped, const QString& error) {
  if (!error.isEmpty()) {
    if (error != told_) emit failed(tr("Live link: %1").arg(error));
    told_ = error;
  } else if (!stopped) {
    told_.clear();
    ++revision_;
    if (running() && writing_ == path_ && ++writtenHere_ == 1) emit message(tr("%1 follows the scene").arg(path_));
  }
  if (again_) soon_.start();
}

void LiveLink::readOne() {
  if (!running() || workspace_.lesson() != nullptr) return turn_.stop();
  if (renderer_.workPending() || document_.previewing()) return;
  for (auto kept = maps_.begin(); kept != maps_.end();) {
    kept = findProbe(document_.scene(), kept->first) ? std::next(kept) : maps_.erase(kept);
  }
  for (const Probe& probe : document_.scene().probes) {
    const BakeState state = renderer_.bakeState(probe.name);
    if (probe.mode == ProbeMode::Baked && state != BakeState::UpToDate && state != BakeState::FromFile) continue;
    if (renderer_.filterMissingLevel(probe.name)) return;
    const auto maps = renderer_.mapsOnCpu(probe.name);
    if (!maps || maps == maps_[probe.name]) continue;
    maps_[probe.name] = maps;
    mapsNew_ = true;
    return;
  }
  turn_.stop();
  if (mapsNew_) changed();
}

}  // namespace boxprobe
