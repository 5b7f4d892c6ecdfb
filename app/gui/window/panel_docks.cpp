// See panel_docks.h.
#include "app/gui/window/panel_docks.h"

#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "app/gui/explain/debug_view.h"
#include "app/gui/panels/bake_panel.h"
#include "app/gui/panels/capture_panel.h"
#include "app/gui/panels/cost_panel.h"
#include "app/gui/panels/fit_panel.h"
#include "app/gui/panels/frame_panel.h"
#include "app/gui/panels/light_panel.h"
#include "app/gui/panels/material_panel.h"
#include "app/gui/panels/object_panel.h"
#include "app/gui/panels/outliner.h"
#include "app/gui/panels/picture_panel.h"
#include "app/gui/panels/place_panel.h"
#include "app/gui/panels/probe_commands.h"
#include "app/gui/panels/probe_panel.h"
#include "app/gui/panels/probe_preview.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_section.h"
#include "app/gui/window/inspectors.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

namespace {

constexpr int kPanelWidth = 450;  // the widest panel, its margins and a scroll bar

QScrollArea* scrolled(QWidget* content) {
  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // What is cut off at the right edge cannot be scrolled to.
  scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
  return scroll;
}

}  // namespace

PanelDocks::PanelDocks(Workspace& workspace, DebugView& debugView, QMainWindow* window)
    : QObject(window), workspace_(workspace), window_(window) {
  window_->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::South);
  buildOutliner();
  buildInspectors();
  buildPictures(debugView);
  first_->raise();
}

void PanelDocks::add(QDockWidget* dock) {
  const bool left = (dock->widget() == outliner_) != window_->isRightToLeft();
  window_->addDockWidget(left ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea, dock);
}

QDockWidget* PanelDocks::addTab(const QString& title, const char* name, QWidget* content) {
  auto* dock = new QDockWidget(title, window_);
  dock->setObjectName(name);
  dock->setWidget(content);
  if (first_ == nullptr) {
    first_ = dock;
    add(dock);
    window_->resizeDocks({dock}, {kPanelWidth}, Qt::Horizontal);
  } else {
    window_->tabifyDockWidget(first_, dock);
  }
  workspace_.actions().view->addAction(dock->toggleViewAction());
  return dock;
}

void PanelDocks::buildOutliner() {
  auto* commands = new ProbeCommands(workspace_, this);
  outliner_ = new Outliner(workspace_, *commands);
  auto* dock = new QDockWidget(tr("Outliner"), window_);
  dock->setObjectName("outliner");
  dock->setWidget(outliner_);
  dock->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  add(dock);
  workspace_.actions().view->addAction(dock->toggleViewAction());
  // One is added to be used: it is fitted at once.
  connect(commands, &ProbeCommands::added, this, [this] {
    if (!fitPanel_->running()) fitPanel_->fit();
  });
}

void PanelDocks::buildInspectors() {
  auto* bakePanel = new BakePanel(workspace_);
  fitPanel_ = new FitPanel(workspace_);
  auto* placePanel = new PlacePanel(workspace_);
  materialPanel_ = new MaterialPanel(workspace_);
  objectPanel_ = new ObjectPanel(workspace_);
  auto* lightPanel = new LightPanel(workspace_);
  inspectors_ = new Inspectors;
  using Page = Inspectors::Page;
  inspectors_->setPanels(Page::Probe,
                         {bakePanel, fitPanel_, placePanel, new ProbePanel(workspace_), new CapturePanel(workspace_)});
  inspectors_->setPanels(Page::Object, {objectPanel_, materialPanel_});
  inspectors_->setPanels(Page::Scene, {lightPanel, new PicturePanel(workspace_)});
  inspectors_->setMinimumWidth(std::max(kPanelWidth, inspectors_->minimumSizeHint().width()));
  QWidget* searched = withSearch(inspectors_, tr("Find a setting"));
  connect(searched->findChild<QLineEdit*>("search"), &QLineEdit::textChanged, inspectors_, &Inspectors::turnToFound);
  addTab(tr("Inspector"), "probes", searched)
      ->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);

  connect(bakePanel, &BakePanel::statesChanged, outliner_, &Outliner::showStates);
  connect(fitPanel_, &FitPanel::ghostChanged, this, [this](const std::optional<Probe>& ghost) {
    fitGhost_ = ghost;
    showGhosts();
  });
  connect(placePanel, &PlacePanel::ghostsChanged, this, [this](const std::vector<Probe>& ghosts) {
    placeGhosts_ = ghosts;
    showGhosts();
  });
  // The outliner is where a user says what is to be inspected; a click in the picture turns no page.
  connect(outliner_, &Outliner::probeChosen, this, [this] { inspectors_->turnTo(Page::Probe); });
  connect(outliner_, &Outliner::objectChosen, this, [this](const QString& node) {
    inspectors_->turnTo(Page::Object);
    show(node, {});
  });
  connect(outliner_, &Outliner::lightChosen, this, [this, lightPanel](std::size_t light) {
    inspectors_->turnTo(Page::Scene);
    lightPanel->choose(light);
  });
  connect(&workspace_, &Workspace::picked, this, &PanelDocks::show);
  connect(&workspace_, &Workspace::fieldsWanted, this, [this](const QString& node, const QString& material) {
    show(node, material);
    first_->raise();
    inspectors_->reveal(objectPanel_);
  });

  using C = Changes;
  workspace_.changes().add("inspectors' headings",
                           {&C::probeList, &C::selection, &C::lights, &C::cameras, &C::models, &C::file},
                           [this](const C&) { showHeadings(); });
  connect(&workspace_.editor(), &Editor::selectionChanged, this, &PanelDocks::showHeadings);
  connect(&workspace_.state(), &ViewState::changed, this, &PanelDocks::showHeadings);
  for (const auto& [panel, name] :
       {std::pair<QWidget*, const char*>{objectPanel_, "object"}, {materialPanel_, "material"}}) {
    connect(panel->findChild<QComboBox*>(name), &QComboBox::currentTextChanged, this, &PanelDocks::showHeadings);
  }
}

void PanelDocks::buildPictures(DebugView& debugView) {
  preview_ = new ProbePreview(workspace_);
  QDockWidget* cubemap = addTab(tr("Cubemap"), "cubemap", scrolled(preview_));
  cubemap->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
  connect(cubemap, &QDockWidget::visibilityChanged, preview_, &ProbePreview::setWatched);
  addTab(tr("Debug"), "debug", scrolled(debugView.panel()));
  QDockWidget* card = addTab(tr("Explain"), "explain", debugView.explainPanel());
  connect(&debugView, &DebugView::toolChanged, card, [card](bool on) {
    if (!on) return;
    card->show();
    card->raise();
  });
  auto* costs = new CostPanel(workspace_);
  connect(addTab(tr("Cost"), "cost", costs), &QDockWidget::visibilityChanged, costs, &CostPanel::setWatched);
  auto* frame = new FramePanel(workspace_);
  connect(addTab(tr("Frame"), "frame", frame), &QDockWidget::visibilityChanged, frame, &FramePanel::setWatched);
}

void PanelDocks::showGhosts() {
  std::vector<Probe> ghosts = placeGhosts_;
  if (fitGhost_) ghosts.push_back(*fitGhost_);
  if (!ghosts.empty()) {  // what is to be reviewed must be seen
    first_->raise();
    inspectors_->turnTo(Inspectors::Page::Probe);
  }
  workspace_.shownHandles().ShowGhosts(ghosts);
  workspace_.requestPicture();
}

void PanelDocks::showHeadings() {
  using Page = Inspectors::Page;
  const Scene& scene = workspace_.editor().scene();
  inspectors_->setEmpty(scene.models.empty());
  if (scene.models.empty()) {
    for (const Page page : {Page::Probe, Page::Object, Page::Scene}) {
      inspectors_->setHeading(page, tr("No scene"), tr("Open a scene or a model (Ctrl+O)."));
    }
    return;
  }
  const std::size_t probes = workspace_.editor().selected().size();
  const Probe* probe = workspace_.editor().probe();
  if (probe == nullptr) {
    inspectors_->setHeading(Page::Probe, tr("No probe"),
                            scene.probes.empty()
                                ? tr("Add one (Ctrl+Shift+A), or place one in every room (Ctrl+Shift+F).")
                                : tr("Select one in the outliner or in the picture."));
  } else {
    const QString name = QString::fromStdString(probe->name);
    inspectors_->setHeading(
        Page::Probe, probes > 1 ? workspace_.editor().selectedName() : name,
        probes > 1
            ? tr("The fields show %1; edits go to all of them.").arg(name)
            : tr("Probe %1 of %2").arg(*workspace_.editor().document().selectedProbe() + 1).arg(scene.probes.size()));
  }
  const ViewState::Names& objects = workspace_.state().objects();
  const QString node = objectPanel_->findChild<QComboBox*>("object")->currentText();
  const QString material = materialPanel_->findChild<QComboBox*>("material")->currentText();
  if (objects.count(node.toStdString()) == 0) {
    inspectors_->setHeading(Page::Object, tr("No object selected"),
                            tr("The lists below choose an object and a material, too."));
  } else {
    const QString own = materialsOf(node).contains(material) ? tr("Its material: %1").arg(material)
                                                             : tr("Below: the material %1").arg(material);
    inspectors_->setHeading(Page::Object, node,
                            objects.size() > 1 ? tr("One of %1 selected. %2").arg(objects.size()).arg(own) : own);
  }
  const std::string& path = workspace_.editor().document().path();
  const QString file = QFileInfo(QString::fromStdString(path.empty() ? scene.models.front().file : path)).fileName();
  inspectors_->setHeading(
      Page::Scene, file,
      tr("Sky, lights and picture. Cameras: %1, lights: %2").arg(scene.cameras.size()).arg(scene.lights.size()));
}

QStringList PanelDocks::materialsOf(const QString& node) const {
  QStringList names;
  const std::string wanted = node.toStdString();
  if (wanted.empty()) return names;
  for (const auto& model : workspace_.models()) {
    for (const Instance& instance : model->instances) {
      const int material = model->meshes[static_cast<std::size_t>(instance.mesh)].material;
      if (material < 0 || instance.node != wanted) continue;
      names += QString::fromStdString(model->materials[static_cast<std::size_t>(material)].name);
    }
  }
  return names;
}

// Nothing is raised, turned or scrolled.
void PanelDocks::show(const QString& node, const QString& material) {
  const QString own = material.isEmpty() ? materialsOf(node).value(0) : material;
  materialPanel_->choose(own.toStdString());
  objectPanel_->choose(node.toStdString());
}

void PanelDocks::stopReading() {
  preview_->setWatched(false);
}

}  // namespace boxprobe
