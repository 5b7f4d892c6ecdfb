// See picture_menu.h.
#include "app/gui/window/picture_menu.h"

#include <QMenu>
#include <algorithm>
#include <vector>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/handles/scene_surfaces.h"
#include "app/gui/view/shown_parts.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "filters/core/geometry/probe_at.h"

namespace boxprobe {

PictureMenu::PictureMenu(Workspace& workspace, QWidget* window)
    : QObject(window), workspace_(workspace), window_(window) {
  connect(&workspace.viewport(), &Viewport::selected, this, &PictureMenu::select);
  connect(&workspace.viewport(), &Viewport::menuRequested, this, &PictureMenu::show);
  connect(&workspace.viewport(), &Viewport::doubleClicked, this, &PictureMenu::selectProbeOf);
  connect(workspace.actions().selectHere, &QAction::triggered, this, &PictureMenu::selectHere);
}

void PictureMenu::select(const QPointF& pixel) {
  const auto object = workspace_.surfaces().objectAt(workspace_.viewport().view().ray({pixel.x(), pixel.y()}));
  workspace_.state().selectObjects(object && !object->node.empty() ? ViewState::Names{object->node}
                                                                   : ViewState::Names());
  if (!object) return;
  const QString node = QString::fromStdString(object->node), material = QString::fromStdString(object->material);
  emit workspace_.message(material.isEmpty() ? tr("Object %1").arg(node)
                                             : tr("Object %1, material %2").arg(node, material));
  emit workspace_.picked(node, material);
}

void PictureMenu::selectProbeOf(const QPointF& pixel) {
  if (const auto point = workspace_.surfaces().meet(workspace_.viewport().view().ray({pixel.x(), pixel.y()}))) {
    selectAt(*point, false);
  }
}

void PictureMenu::selectHere() {
  selectAt(workspace_.viewport().view().eyeWorld(), true);
}

void PictureMenu::selectAt(const glm::dvec3& pointWorld, bool orNearest) {
  const auto& probes = workspace_.editor().scene().probes;
  const auto lighting = probeLighting(probes, pointWorld);
  const auto chosen = lighting || !orNearest ? lighting : probeNearest(probes, pointWorld);
  if (!chosen) return emit workspace_.message(tr("No probe lights this place; the sky does"));
  workspace_.editor().selectProbe(chosen);
  const QString name = QString::fromStdString(probes[*chosen].name);
  emit workspace_.message(lighting ? tr("Probe %1 lights this place").arg(name)
                                   : tr("No probe lights this place; %1 is the nearest").arg(name));
}

std::unique_ptr<QMenu> PictureMenu::menuAt(const QPointF& pixel) {
  auto menu = std::make_unique<QMenu>(window_);
  const std::vector<std::size_t> selected = workspace_.editor().selected();
  const auto under = workspace_.handles().probeAt(pixel);
  if (under && std::find(selected.begin(), selected.end(), *under) == selected.end())
    workspace_.editor().selectProbe(*under);
  if (workspace_.editor().probe() != nullptr) {
    const QString name = workspace_.editor().selectedName();
    menu->addSection(workspace_.editor().selected().size() > 1 ? name : tr("Probe %1").arg(name));
    const bool alone = workspace_.state().objects().empty();
    for (QAction* action : alone ? workspace_.actions().ofProbe() : workspace_.actions().ofProbeBesideObject()) {
      menu->addAction(action);
    }
  }
  const auto object = workspace_.surfaces().objectAt(workspace_.viewport().view().ray({pixel.x(), pixel.y()}));
  if (!object || object->node.empty()) return menu;
  const std::string node = object->node;
  menu->addSection(tr("Object %1").arg(QString::fromStdString(node)));
  QAction* show = menu->addAction(tr("Show in the panels"));
  const QString material = QString::fromStdString(object->material);
  connect(show, &QAction::triggered, this, [this, node, material] {
    workspace_.state().selectObjects({node});
    emit workspace_.fieldsWanted(QString::fromStdString(node), material);
  });
  menu->addAction(tr("&Hide"), this, [this, node] { workspace_.shown().setHidden({}, {node}, true); });
  menu->addAction(
      workspace_.state().isolated() ? tr("Show the &others again") : tr("Show it a&lone"), this, [this, node] {
        const Probe* probe = workspace_.editor().probe();
        workspace_.shown().isolate(probe != nullptr ? ViewState::Names{probe->name} : ViewState::Names(), {node});
      });
  if (workspace_.state().isolated() || workspace_.state().anyHidden()) {
    menu->addAction(tr("Show &all hidden"), &workspace_.state(), &ViewState::showAll);
  }
  if (const Probe* probe = workspace_.editor().probe()) {
    const bool out = std::find(probe->hides.begin(), probe->hides.end(), node) != probe->hides.end();
    QAction* leave = menu->addAction(tr("Leave out of the capture of %1").arg(workspace_.editor().selectedName()));
    leave->setCheckable(true);
    leave->setChecked(out);
    connect(leave, &QAction::triggered, this, [this, node](bool checked) { leaveOut(node, checked); });
  }
  return menu;
}

void PictureMenu::show(const QPointF& pixel) {
  const auto menu = menuAt(pixel);
  if (!menu->isEmpty()) menu->exec(workspace_.viewport().mapToGlobal(pixel.toPoint()));
}

void PictureMenu::leaveOut(const std::string& node, bool out) {
  const QString name = QString::fromStdString(node);
  workspace_.editor().commitProbe(out ? tr("Leave %1 out").arg(name) : tr("Capture %1 again").arg(name),
                                  [node, out](Probe& probe) {
                                    auto& hides = probe.hides;
                                    hides.erase(std::remove(hides.begin(), hides.end(), node), hides.end());
                                    if (out) hides.push_back(node);
                                  });
}

}  // namespace boxprobe
