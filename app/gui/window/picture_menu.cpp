// See picture_menu.h.
#include "app/gui/window/picture_menu.h"

#include <QInputDialog>
#include <QMenu>
#include <algorithm>
#include <vector>

#include "app/gui/edit/editor.h"
#include "app/gui/edit/view_state.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/handles/scene_surfaces.h"
#include "app/gui/view/shown_scene.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/menu_bar.h"
#include "filters/core/geometry/probe_at.h"

namespace boxprobe {

PictureMenu::PictureMenu(const Parts& parts, QWidget* window) : QObject(window), parts_(parts), window_(window) {}

void PictureMenu::select(const QPointF& pixel) {
  const auto object = parts_.surfaces.objectAt(parts_.viewport.view().ray({pixel.x(), pixel.y()}));
  parts_.state.selectObjects(object && !object->node.empty() ? ViewState::Names{object->node} : ViewState::Names());
  if (!object) return;
  const QString node = QString::fromStdString(object->node), material = QString::fromStdString(object->material);
  emit message(material.isEmpty() ? tr("Object %1").arg(node) : tr("Object %1, material %2").arg(node, material));
  emit picked(node, material);
}

void PictureMenu::selectProbeOf(const QPointF& pixel) {
  if (const auto point = parts_.surfaces.meet(parts_.viewport.view().ray({pixel.x(), pixel.y()}))) {
    selectAt(*point, false);
  }
}

void PictureMenu::selectHere() {
  selectAt(parts_.viewport.view().eyeWorld(), true);
}

void PictureMenu::selectAt(const glm::dvec3& pointWorld, bool orNearest) {
  const auto& probes = parts_.editor.scene().probes;
  const auto lighting = probeLighting(probes, pointWorld);
  const auto chosen = lighting || !orNearest ? lighting : probeNearest(probes, pointWorld);
  if (!chosen) return emit message(tr("No probe lights this place; the sky does"));
  parts_.editor.selectProbe(chosen);
  const QString name = QString::fromStdString(probes[*chosen].name);
  emit message(lighting ? tr("Probe %1 lights this place").arg(name)
                        : tr("No probe lights this place; %1 is the nearest").arg(name));
}

std::unique_ptr<QMenu> PictureMenu::menuAt(const QPointF& pixel) {
  auto menu = std::make_unique<QMenu>(window_);
  const std::vector<std::size_t> selected = parts_.editor.selected();
  const auto under = parts_.handles.probeAt(pixel);
  if (under && std::find(selected.begin(), selected.end(), *under) == selected.end()) parts_.editor.selectProbe(*under);
  if (parts_.editor.probe() != nullptr) {
    const QString name = parts_.editor.selectedName();
    menu->addSection(parts_.editor.selected().size() > 1 ? name : tr("Probe %1").arg(name));
    const bool alone = parts_.state.objects().empty();
    for (QAction* action : alone ? parts_.menu.probeActions() : parts_.menu.probeActionsBesideObject()) {
      menu->addAction(action);
    }
  }
  const auto object = parts_.surfaces.objectAt(parts_.viewport.view().ray({pixel.x(), pixel.y()}));
  if (!object || object->node.empty()) return menu;
  const std::string node = object->node;
  menu->addSection(tr("Object %1").arg(QString::fromStdString(node)));
  QAction* show = menu->addAction(tr("Show in the panels"));
  const QString material = QString::fromStdString(object->material);
  connect(show, &QAction::triggered, this, [this, node, material] {
    parts_.state.selectObjects({node});
    emit shownInPanels(QString::fromStdString(node), material);
  });
  menu->addAction(tr("&Hide"), this, [this, node] { parts_.shown.setHidden({}, {node}, true); });
  menu->addAction(parts_.state.isolated() ? tr("Show the &others again") : tr("Show it a&lone"), this, [this, node] {
    const Probe* probe = parts_.editor.probe();
    parts_.shown.isolate(probe != nullptr ? ViewState::Names{probe->name} : ViewState::Names(), {node});
  });
  if (parts_.state.isolated() || parts_.state.anyHidden()) {
    menu->addAction(tr("Show &all hidden"), &parts_.shown, &ShownScene::showAll);
  }
  if (const Probe* probe = parts_.editor.probe()) {
    const bool out = std::find(probe->hides.begin(), probe->hides.end(), node) != probe->hides.end();
    QAction* leave = menu->addAction(tr("Leave out of the capture of %1").arg(parts_.editor.selectedName()));
    leave->setCheckable(true);
    leave->setChecked(out);
    connect(leave, &QAction::triggered, this, [this, node](bool checked) { leaveOut(node, checked); });
  }
  return menu;
}

void PictureMenu::show(const QPointF& pixel) {
  const auto menu = menuAt(pixel);
  if (!menu->isEmpty()) menu->exec(parts_.viewport.mapToGlobal(pixel.toPoint()));
}

void PictureMenu::leaveOut(const std::string& node, bool out) {
  const QString name = QString::fromStdString(node);
  parts_.editor.commitProbe(out ? tr("Leave %1 out").arg(name) : tr("Capture %1 again").arg(name),
                            [node, out](Probe& probe) {
                              auto& hides = probe.hides;
                              hides.erase(std::remove(hides.begin(), hides.end(), node), hides.end());
                              if (out) hides.push_back(node);
                            });
}

void PictureMenu::storeCamera() {
  bool accepted = false;
  const QString name = QInputDialog::getText(window_, tr("Store this view"), tr("Name of the camera"),
                                             QLineEdit::Normal, tr("view"), &accepted);
  if (accepted) parts_.views.storeCamera(name);
}

void PictureMenu::renameCamera(int index) {
  const auto& cameras = parts_.editor.scene().cameras;
  if (static_cast<std::size_t>(index) >= cameras.size()) return;
  bool accepted = false;
  const QString was = QString::fromStdString(cameras[static_cast<std::size_t>(index)].name);
  const QString name =
      QInputDialog::getText(window_, tr("Rename camera"), tr("Name of the camera"), QLineEdit::Normal, was, &accepted);
  if (accepted) parts_.views.renameCamera(index, name);
}

}  // namespace boxprobe
