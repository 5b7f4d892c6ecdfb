// See bake_panel.h.
#include "app/gui/panels/bake_panel.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <exception>

#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/message_box.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/session/opened_glb.h"
#include "app/session/program_name.h"
#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/engines/glb_probes.h"

namespace boxprobe {

BakePanel::BakePanel(Workspace& workspace)
    : workspace_(workspace),
      editor_(workspace.editor()),
      renderer_(workspace.renderer()),
      scheduler_(workspace.scheduler()),
      mark_(new QLabel(this)),
      state_(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Bake"));
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(mark_);
  row->addWidget(state_, 1);
  state_->setObjectName("bakeState");
  state_->setWordWrap(true);
  addRow(form, tr("State"), line, tr("Progress of the selected probe's cubemap"));

  auto* buttons = new QHBoxLayout;
  bake_ =
      addButton(tr("Bake"), "bake", tr("Recaptures and filters the selected probes (F5)"), &BakePanel::bakeSelected);
  bakeAll_ =
      addButton(tr("Bake all"), "bakeAll", tr("Recaptures and filters every probe (Shift+F5)"), &BakePanel::bakeAll);
  stop_ = addButton(tr("Stop"), "stopBake", tr("Stops the work until the scene changes again (Esc)"), &BakePanel::stop);
  save_ = addButton(tr("Save files..."), "saveBaked",
                    tr("Writes every baked probe to an OpenEXR file in a folder. In the folder beside the scene they "
                       "are loaded instead of captured"),
                    &BakePanel::saveBaked);
  for (QToolButton* button : {bake_, bakeAll_, stop_, save_}) buttons->addWidget(button);
  buttons->addStretch(1);
  form->addRow(buttons);

  connect(&scheduler_, &RenderScheduler::workProgressed, this, &BakePanel::update);
  connect(&scheduler_, &RenderScheduler::workEnded, this, &BakePanel::update);
  connect(&scheduler_, &RenderScheduler::workEnded, this, &BakePanel::tellStale);
  workspace.listenTo(this);
  connect(&workspace, &Workspace::modelsReplaced, this, &BakePanel::useFilesBeside);
  connect(workspace.actions().bake, &QAction::triggered, this, &BakePanel::bakeSelected);
  connect(workspace.actions().bakeAll, &QAction::triggered, this, &BakePanel::bakeAll);
  connect(workspace.actions().saveBaked, &QAction::triggered, this, &BakePanel::saveBaked);
  // Whatever makes a capture stale, or an object use a probe.
  using C = Changes;
  workspace.changes().add("bake panel",
                          {&C::probeShape, &C::probeTechnique, &C::probeCapture, &C::probeList, &C::selection,
                           &C::materials, &C::objects, &C::lights, &C::sky, &C::models},
                          [this](const C&) { update(); });
  connect(&editor_, &Editor::selectionChanged, this, &BakePanel::update);
}

QToolButton* BakePanel::addButton(const QString& text, const char* name, const QString& toolTip,
                                  void (BakePanel::*action)()) {
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setObjectName(name);
  button->setToolTip(toolTip);
  connect(button, &QToolButton::clicked, this, action);
  return button;
}

void BakePanel::update() {
  const auto selected = editor_.document().selectedProbe();
  std::vector<BakeStateLook> looks;
  for (const Probe& probe : editor_.scene().probes) {
    looks.push_back(bakeStateLook(probe, renderer_.bakeState(probe.name), scheduler_.workStopped()));
  }
  const BakeStateLook look = selected ? looks[*selected] : BakeStateLook{tr("No probe selected"), QColor(), false};
  if (state_->text() != look.text) {
    state_->setText(look.text);
    mark_->setPixmap(selected ? stateIcon(look).pixmap(16, 16) : QPixmap());
  }
  const bool busy = renderer_.workPending() && !scheduler_.workStopped();
  bool baked = false;
  for (const Probe& probe : editor_.scene().probes) baked |= probe.mode == ProbeMode::Baked;
  const std::size_t count = editor_.selected().size();
  bake_->setText(count > 1 ? tr("Bake %1").arg(count) : tr("Bake"));
  bake_->setEnabled(selected.has_value());
  bakeAll_->setEnabled(!looks.empty());
  stop_->setEnabled(busy);
  save_->setEnabled(baked && toSave_.empty());
  if (looks != shown_) {
    shown_ = looks;
    emit statesChanged(shown_);
  }
  if (renderer_.pictureError() != pictureError_) {
    pictureError_ = renderer_.pictureError();
    if (!pictureError_.empty()) emit failed(QString::fromStdString(pictureError_));
  }
}

void BakePanel::useFilesBeside() {
  const std::string& path = workspace_.shownPath();
  // A .glb with probes has its baked files in itself; beside another model there are none.
  const bool bare = isModelPath(path) && !holdsProbes(path);
  std::string folder;
  try {
    if (!path.empty() && !bare) folder = bakedFolderOf(path);
  } catch (const std::exception& error) {
    emit failed(QString::fromStdString(messageOf(error)));
  }
  renderer_.useBakedFiles(folder);
  const QDir files(QString::fromStdString(folder));
  checkFiles_ = !folder.empty() && !files.entryList({"*.exr"}, QDir::Files).isEmpty();
}

// Once after a scene was opened: files that were there and did not hold.
void BakePanel::tellStale() {
  if (!checkFiles_ || renderer_.workPending()) return;
  checkFiles_ = false;
  int baked = 0, stale = 0;
  for (const Probe& probe : editor_.scene().probes) {
    if (probe.mode != ProbeMode::Baked) continue;
    ++baked;
    stale += renderer_.bakeState(probe.name) == BakeState::UpToDate ? 1 : 0;
  }
  if (stale == 0) return;
  emit message(
      tr("%1 of %2 baked files are missing or out of date: those probes were captured again. Save baked probes "
         "to renew the files")
          .arg(stale)
          .arg(baked));
}

void BakePanel::bake(const std::vector<std::string>& names) {
  editor_.finish();
  emit workspace_.documentSceneWanted();
  checkFiles_ = false;  // what is captured from now on was asked for
  renderer_.requestBake(names);
  scheduler_.sceneChanged();
  update();
}

void BakePanel::bakeSelected() {
  std::vector<std::string> names;
  for (const std::size_t index : editor_.selected()) names.push_back(editor_.scene().probes[index].name);
  if (!names.empty()) bake(names);
}

void BakePanel::bakeAll() {
  std::vector<std::string> names;
  for (const Probe& probe : editor_.scene().probes) names.push_back(probe.name);
  bake(names);
}

void BakePanel::stop() {
  scheduler_.stopWork();
  update();
}

QString BakePanel::chooseFolder() {
  const std::string& scene = editor_.document().path();
  const QString start = scene.empty() ? QString() : QFileInfo(QString::fromStdString(scene)).absolutePath();
  if (!scene.empty()) {
    const QString beside = QString::fromStdString(BakeFolder::besideScene(scene));
    PlainQuestion box(window(), tr("Save baked probes"),
                      tr("Save the baked probes to %1, where the scene finds them?").arg(beside),
                      QMessageBox::Save | QMessageBox::Cancel);
    const auto* other = box.addButton(tr("Another folder..."), QMessageBox::ActionRole);
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (box.clickedButton() != other) return answer == QMessageBox::Save ? beside : QString();
  }
  return QFileDialog::getExistingDirectory(window(), tr("Save baked probes to a folder"), start);
}

void BakePanel::saveBaked() {
  editor_.finish();
  if (!toSave_.empty()) return;
  folder_ = chooseFolder();
  if (folder_.isEmpty()) return;
  saved_ = 0;
  notFinished_.clear();
  renderer_.sharpenMirrors(0);  // files are of the scene's own size
  toSave_ = {std::string()};    // the sky, which completes the set
  for (auto it = editor_.scene().probes.rbegin(); it != editor_.scene().probes.rend(); ++it) {
    if (it->mode == ProbeMode::Baked) toSave_.push_back(it->name);
  }
  update();
  saveNext();
}

void BakePanel::saveNext() {
  try {
    emit workspace_.documentSceneWanted();
    const std::string name = toSave_.back();
    // A level at a time, so that the window goes on answering.
    if (renderer_.filterMissingLevel(name)) {
      QTimer::singleShot(0, this, &BakePanel::saveNext);
      return;
    }
    toSave_.pop_back();
    const std::string path = renderer_.saveBaked(name, folder_.toStdString(), kProgramName);
    if (!path.empty()) ++saved_;
    if (path.empty() && !name.empty()) notFinished_.push_back(QString::fromStdString(name));
    if (!toSave_.empty()) {
      emit message(tr("Saving baked probes: %1 left").arg(toSave_.size()));
      QTimer::singleShot(0, this, &BakePanel::saveNext);
      return;
    }
    // What was written now need not be captured again after an undo.
    const std::string& scene = editor_.document().path();
    renderer_.useBakedFiles(scene.empty() ? std::string() : BakeFolder::besideScene(scene));
    checkFiles_ = false;
    const QString done =
        saved_ == 1 ? tr("Wrote 1 file to %1").arg(folder_) : tr("Wrote %1 files to %2").arg(saved_).arg(folder_);
    if (notFinished_.isEmpty()) {
      emit message(done);
    } else {
      emit failed(tr("%1; not written because not finished: %2").arg(done, notFinished_.join(", ")));
    }
  } catch (const std::exception& error) {
    toSave_.clear();
    emit failed(QString::fromStdString(messageOf(error)));
  }
  update();
}

}  // namespace boxprobe
