// See panel_docks.h.
#include "app/gui/window/panel_docks.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QMainWindow>
#include <QProgressDialog>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/gui/edit/probe_gauge.h"
#include "app/gui/edit/view_state.h"
#include "app/gui/explain/debug_view.h"
#include "app/gui/explain/explain_card.h"
#include "app/gui/explain/surface_view_panel.h"
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
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/panel_section.h"
#include "app/gui/widgets/table_words.h"
#include "app/gui/window/inspectors.h"
#include "app/gui/window/menu_bar.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/scene_renderer.h"

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

PanelDocks::PanelDocks(QMainWindow* window, const Parts& parts) : QObject(window), window_(window), parts_(parts) {
  window_->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::South);
  buildOutliner();
  buildProbes();
  buildPreview();
  buildDebug();
  buildCost();
  buildFrame();
  first_->raise();
}

QDockWidget* PanelDocks::add(const QString& title, const char* name, QWidget* content) {
  auto* dock = new QDockWidget(title, window_);
  dock->setObjectName(name);
  dock->setWidget(content);
  if (first_ == nullptr) {
    first_ = dock;
    window_->addDockWidget(window_->isRightToLeft() ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea, dock);
    window_->resizeDocks({dock}, {kPanelWidth}, Qt::Horizontal);
  } else {
    window_->tabifyDockWidget(first_, dock);
  }
  parts_.menu.addDockToggle(dock->toggleViewAction());
  return dock;
}

void PanelDocks::buildOutliner() {
  Editor& editor = parts_.editor;
  SceneRenderer& renderer = parts_.renderer;
  commands_ = new ProbeCommands(editor,
                                {[&renderer] {
                                   const double* target = renderer.renderer()->GetActiveCamera()->GetFocalPoint();
                                   return glm::dvec3(target[0], target[1], target[2]);
                                 },
                                 [&renderer] { return renderer.bounds(); }},
                                this);
  outliner_ = new Outliner(editor, parts_.state, *commands_);
  outliner_->setProbeActions(parts_.menu.probeActions());
  auto* dock = new QDockWidget(tr("Outliner"), window_);
  dock->setObjectName("outliner");
  dock->setWidget(outliner_);
  dock->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  window_->addDockWidget(window_->isRightToLeft() ? Qt::RightDockWidgetArea : Qt::LeftDockWidgetArea, dock);
  parts_.menu.addDockToggle(dock->toggleViewAction());
}

void PanelDocks::buildProbes() {
  Editor& editor = parts_.editor;
  SceneRenderer& renderer = parts_.renderer;
  bakePanel_ = new BakePanel(editor, renderer, parts_.scheduler);
  fitPanel_ = new FitPanel(editor);
  placePanel_ = new PlacePanel(editor);
  probePanel_ = new ProbePanel(editor);
  capturePanel_ = new CapturePanel(editor);
  materialPanel_ = new MaterialPanel(editor);
  objectPanel_ = new ObjectPanel(editor);
  lightPanel_ = new LightPanel(editor, [&renderer] { return renderer.currentCamera(); });
  picturePanel_ = new PicturePanel(editor);
  inspectors_ = new Inspectors;
  using Page = Inspectors::Page;
  inspectors_->setPanels(Page::Probe, {bakePanel_, fitPanel_, placePanel_, probePanel_, capturePanel_});
  inspectors_->setPanels(Page::Object, {objectPanel_, materialPanel_});
  inspectors_->setPanels(Page::Scene, {lightPanel_, picturePanel_});
  inspectors_->setMinimumWidth(std::max(kPanelWidth, inspectors_->minimumSizeHint().width()));
  QWidget* searched = withSearch(inspectors_, tr("Find a setting"));
  connect(searched->findChild<QLineEdit*>("search"), &QLineEdit::textChanged, inspectors_, &Inspectors::turnToFound);
  add(tr("Inspector"), "probes", searched)
      ->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
  connect(&parts_.state, &ViewState::changed, this, &PanelDocks::showHeadings);
  for (const auto& [panel, name] :
       {std::pair<QWidget*, const char*>{objectPanel_, "object"}, {materialPanel_, "material"}}) {
    connect(panel->findChild<QComboBox*>(name), &QComboBox::currentTextChanged, this, &PanelDocks::showHeadings);
  }
  // The outliner is where a user says what is to be inspected; a click in the picture turns no page.
  connect(outliner_, &Outliner::probeChosen, this, [this] { inspectors_->turnTo(Inspectors::Page::Probe); });
  connect(outliner_, &Outliner::objectChosen, this, [this] { inspectors_->turnTo(Inspectors::Page::Object); });
  connect(outliner_, &Outliner::lightChosen, this, [this] { inspectors_->turnTo(Inspectors::Page::Scene); });
  connect(&editor, &Editor::selectionChanged, this, &PanelDocks::showSelection);
  connect(bakePanel_, &BakePanel::statesChanged, outliner_, &Outliner::showStates);
  connect(bakePanel_, &BakePanel::message, this, &PanelDocks::message);
  connect(bakePanel_, &BakePanel::failed, this, &PanelDocks::failed);
  connect(commands_, &ProbeCommands::added, fitPanel_, [this] {
    if (!fitPanel_->running()) fitPanel_->fit();
  });
  connect(fitPanel_, &FitPanel::ghostChanged, this, [this](const std::optional<Probe>& ghost) {
    fitGhost_ = ghost;
    showGhosts();
  });
  connect(placePanel_, &PlacePanel::ghostsChanged, this, [this](const std::vector<Probe>& ghosts) {
    placeGhosts_ = ghosts;
    showGhosts();
  });
  connect(placePanel_, &PlacePanel::message, this, &PanelDocks::message);
  connect(placePanel_, &PlacePanel::failed, this, &PanelDocks::failed);
  connect(fitPanel_, &FitPanel::message, this, &PanelDocks::message);
  connect(fitPanel_, &FitPanel::failed, this, &PanelDocks::failed);
}

void PanelDocks::showSelection() {
  outliner_->update();
  probePanel_->update();
  capturePanel_->update();
  bakePanel_->update();
  parts_.menu.showSelected(parts_.editor.selected().size());
  showHeadings();
}

void PanelDocks::showHeadings() {
  using Page = Inspectors::Page;
  const Scene& scene = parts_.editor.scene();
  inspectors_->setEmpty(scene.models.empty());
  if (scene.models.empty()) {
    for (const Page page : {Page::Probe, Page::Object, Page::Scene}) {
      inspectors_->setHeading(page, tr("No scene"), tr("Open a scene or a model (Ctrl+O)."));
    }
    return;
  }
  const std::size_t probes = parts_.editor.selected().size();
  const Probe* probe = parts_.editor.probe();
  if (probe == nullptr) {
    inspectors_->setHeading(Page::Probe, tr("No probe"),
                            scene.probes.empty()
                                ? tr("Add one (Ctrl+Shift+A), or place one in every room (Ctrl+Shift+F).")
                                : tr("Select one in the outliner or in the picture."));
  } else {
    const QString name = QString::fromStdString(probe->name);
    inspectors_->setHeading(
        Page::Probe, probes > 1 ? parts_.editor.selectedName() : name,
        probes > 1 ? tr("The fields show %1; edits go to all of them.").arg(name)
                   : tr("Probe %1 of %2").arg(*parts_.editor.document().selectedProbe() + 1).arg(scene.probes.size()));
  }
  const ViewState::Names& objects = parts_.state.objects();
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
  const std::string& path = parts_.editor.document().path();
  const QString file = QFileInfo(QString::fromStdString(path.empty() ? scene.models.front().file : path)).fileName();
  inspectors_->setHeading(
      Page::Scene, file,
      tr("Sky, lights and picture. Cameras: %1, lights: %2").arg(scene.cameras.size()).arg(scene.lights.size()));
}

void PanelDocks::showGhosts() {
  std::vector<Probe> ghosts = placeGhosts_;
  if (fitGhost_) ghosts.push_back(*fitGhost_);
  if (!ghosts.empty()) {  // what is to be reviewed must be seen
    first_->raise();
    inspectors_->turnTo(Inspectors::Page::Probe);
  }
  emit ghostsChanged(ghosts);
}

void PanelDocks::buildPreview() {
  Viewport& viewport = parts_.viewport;
  preview_ = new ProbePreview(parts_.editor, parts_.renderer, [&viewport] { viewport.window3d()->MakeCurrent(); });
  QDockWidget* dock = add(tr("Cubemap"), "cubemap", scrolled(preview_));
  dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
  connect(dock, &QDockWidget::visibilityChanged, preview_, &ProbePreview::setWatched);
  connect(preview_, &ProbePreview::pictureChanged, this, &PanelDocks::pictureChanged);
  connect(&parts_.scheduler, &RenderScheduler::rendered, preview_, &ProbePreview::update);
}

void PanelDocks::buildDebug() {
  DebugView& debugView = parts_.debugView;
  add(tr("Debug"), "debug", scrolled(debugView.panel()));
  SurfaceViewPanel* views = debugView.surfacePanel();
  QStringList names;
  for (const SurfaceViewRow& row : surfaceViews()) names.append(tableWords(row.label));
  parts_.menu.addSurfaceViews(names);
  connect(&parts_.menu, &MenuBar::surfaceViewChosen, views, &SurfaceViewPanel::choose);
  connect(views, &SurfaceViewPanel::changed, &parts_.menu,
          [this](const SurfaceViewSettings& settings) { parts_.menu.showSurfaceView(settings.view); });
  QDockWidget* card = add(tr("Explain"), "explain", debugView.explainPanel());
  connect(&debugView, &DebugView::toolChanged, card, [card](bool on) {
    if (!on) return;
    card->show();
    card->raise();
  });
}

void PanelDocks::buildCost() {
  costPanel_ = new CostPanel(parts_.editor);
  QDockWidget* dock = add(tr("Cost"), "cost", costPanel_);
  connect(dock, &QDockWidget::visibilityChanged, costPanel_, &CostPanel::setWatched);
  connect(costPanel_, &CostPanel::message, this, &PanelDocks::message);
  connect(costPanel_, &CostPanel::failed, this, &PanelDocks::failed);
}

FrameCosts PanelDocks::measureCosts() {
  constexpr int kRounds = 5;
  QProgressDialog shown(tr("Measuring where the time of a frame goes ..."), tr("Stop"), 0, 100, framePanel_);
  shown.setObjectName("costsProgress");
  shown.setWindowModality(Qt::ApplicationModal);
  shown.setMinimumDuration(0);
  FrameCosts costs;
  try {
    costs = measureFrameCosts(
        parts_.renderer, kRounds, [this] { return timedFrameOf(parts_.viewport.window3d()); },
        [&shown](double fraction) {
          shown.setValue(static_cast<int>(99.0 * fraction));
          return !shown.wasCanceled();
        });
  } catch (const Error& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
  parts_.scheduler.requestRender();
  return costs;
}

void PanelDocks::buildFrame() {
  const Parts& p = parts_;
  framePanel_ = new FramePanel(p.editor, {[&r = p.renderer] { return r.frameReport(); },
                                          [&r = p.renderer, &view = p.viewport, &scheduler = p.scheduler] {
                                            view.window3d()->MakeCurrent();
                                            const int* size = view.window3d()->GetSize();
                                            const auto lookups = r.measureLookups(size[0], size[1]);
                                            scheduler.requestRender();
                                            return lookups;
                                          },
                                          [this] { return measureCosts(); }});
  QDockWidget* dock = add(tr("Frame"), "frame", framePanel_);
  connect(dock, &QDockWidget::visibilityChanged, framePanel_, &FramePanel::setWatched);
  connect(&p.scheduler, &RenderScheduler::rendered, framePanel_, &FramePanel::update);
  SurfaceViewPanel* views = p.debugView.surfacePanel();
  const int lookups = *findSurfaceView("lookups");
  connect(framePanel_, &FramePanel::heatMapSwitched, views,
          [views, lookups](bool on) { views->choose(on ? lookups : 0); });
  connect(views, &SurfaceViewPanel::changed, framePanel_,
          [this, lookups](const SurfaceViewSettings& settings) { framePanel_->showHeatMap(settings.view == lookups); });
}

void PanelDocks::subscribe(ChangeViews& views) {
  using C = Changes;
  views.add("outliner", {&C::probeList, &C::selection, &C::materials, &C::lights, &C::cameras, &C::models},
            [this](const C&) { outliner_->update(); });
  views.add("probe commands", {&C::probeList, &C::selection},
            [this](const C&) { parts_.menu.showSelected(parts_.editor.selected().size()); });
  views.add("inspectors' headings", {&C::probeList, &C::selection, &C::lights, &C::cameras, &C::models, &C::file},
            [this](const C&) { showHeadings(); });
  views.add("fit panel", selectedProbeKinds(), [this](const C&) { fitPanel_->update(); });
  views.add("live error",
            {&C::probeShape, &C::probeCapture, &C::probeList, &C::selection, &C::materials, &C::objects, &C::models,
             &C::cameras},
            [this](const C&) { fitPanel_->gauge().update(); });
  views.add(
      "place panel",
      {&C::probeShape, &C::probeTechnique, &C::probeCapture, &C::probeList, &C::materials, &C::objects, &C::models},
      [this](const C&) { placePanel_->update(); });
  views.add("probe panel", selectedProbeKinds(), [this](const C&) { probePanel_->update(); });
  // Whatever makes a capture stale, or an object use a probe.
  views.add("bake panel",
            {&C::probeShape, &C::probeTechnique, &C::probeCapture, &C::probeList, &C::selection, &C::materials,
             &C::objects, &C::lights, &C::sky, &C::models},
            [this](const C&) { bakePanel_->update(); });
  views.add("capture panel", {&C::probeCapture, &C::probeList, &C::selection},
            [this](const C&) { capturePanel_->update(); });
  views.add("material panel", {&C::materials, &C::models}, [this](const C&) { materialPanel_->update(); });
  views.add("object panel", {&C::objects, &C::models}, [this](const C&) { objectPanel_->update(); });
  views.add("light panel", {&C::lights, &C::sky}, [this](const C&) { lightPanel_->update(); });
  views.add("picture panel", {&C::exposure}, [this](const C&) { picturePanel_->update(); });
  // Its maps come with the pictures that follow them.
  views.add("cubemap", {&C::probeList, &C::selection, &C::exposure}, [this](const C&) { preview_->update(); });
  views.add("cost panel", {&C::probeTechnique, &C::probeList, &C::selection, &C::file, &C::models},
            [this](const C&) { costPanel_->update(); });
}

void PanelDocks::setModels(const std::vector<std::shared_ptr<const Model>>& models) {
  models_ = models;
  outliner_->setModels(models);
  capturePanel_->setModels(models);
  fitPanel_->setModels(models);
  placePanel_->setModels(models);
  materialPanel_->setModels(models);
  objectPanel_->setModels(models);
  costPanel_->sceneReplaced();
}

QStringList PanelDocks::materialsOf(const QString& node) const {
  QStringList names;
  const std::string wanted = node.toStdString();
  if (wanted.empty()) return names;
  for (const auto& model : models_) {
    for (const Instance& instance : model->instances) {
      const int material = model->meshes[static_cast<std::size_t>(instance.mesh)].material;
      if (material < 0 || instance.node != wanted) continue;
      names += QString::fromStdString(model->materials[static_cast<std::size_t>(material)].name);
    }
  }
  return names;
}

void PanelDocks::show(const QString& node, const QString& material) {
  const QString own = material.isEmpty() ? materialsOf(node).value(0) : material;
  materialPanel_->choose(own.toStdString());
  objectPanel_->choose(node.toStdString());
}

void PanelDocks::reveal(const QString& node, const QString& material) {
  show(node, material);
  first_->raise();
  inspectors_->reveal(objectPanel_);
}

void PanelDocks::stopReading() {
  preview_->setWatched(false);
}

}  // namespace boxprobe
