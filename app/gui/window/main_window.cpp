// See main_window.h.
#include "app/gui/window/main_window.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QCloseEvent>
#include <QDockWidget>
#include <QMimeData>
#include <QScrollArea>
#include <QStatusBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/gui/explain/debug_view.h"
#include "app/gui/explain/explain_card.h"
#include "app/gui/explain/surface_view_panel.h"
#include "app/gui/handles/probe_overlay.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/lessons/lesson_panel.h"
#include "app/gui/lessons/lesson_view.h"
#include "app/gui/panels/bake_panel.h"
#include "app/gui/panels/capture_panel.h"
#include "app/gui/panels/cost_panel.h"
#include "app/gui/panels/frame_panel.h"
#include "app/gui/panels/light_panel.h"
#include "app/gui/panels/material_panel.h"
#include "app/gui/panels/object_panel.h"
#include "app/gui/panels/picture_panel.h"
#include "app/gui/panels/probe_list.h"
#include "app/gui/panels/probe_panel.h"
#include "app/gui/panels/probe_preview.h"
#include "app/gui/view/motion_preview.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/recent_files.h"
#include "app/gui/window/about_dialog.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/menu_bar.h"
#include "app/gui/window/projector.h"
#include "app/gui/window/status_line.h"
#include "app/session/fit_scene.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr int kPanelWidth = 450;  // the widest panel, its margins and a scroll bar
constexpr int kLessonWidth = 400;

}  // namespace

MainWindow::MainWindow()
    : editor_(std::make_unique<Editor>(document_)),
      viewport_(new Viewport(this)),
      renderer_(std::make_unique<SceneRenderer>(viewport_->window3d())),
      overlay_(std::make_unique<ProbeOverlay>(viewport_->window3d(), renderer_->renderer())),
      probeWidget_(new ProbeWidget(
          *editor_, *overlay_, [this] { return viewport_->view(); }, this)),
      scheduler_(new RenderScheduler(
          {[this] { return viewport_->readyToDraw(); }, [this] { guarded([this] { drawPicture(); }); },
           [this] { return renderer_->workPending(); },
           [this] {
             guarded([this] {
               viewport_->window3d()->MakeCurrent();
               renderer_->step();
             });
           },
           [this] { return renderer_->workProgress(); },
           [this] { return renderer_->frameCount().more() && renderer_->error().empty(); }},
          this)),
      motion_(new MotionPreview({[this](bool allowed) { renderer_->allowStandIns(allowed); },
                                 [this](bool moving) { return renderer_->setMoving(moving); }},
                                this)),
      files_(new FileCommands(
          document_, *editor_,
          {[this](LoadedScene loaded) { showScene(std::move(loaded)); },
           [this](const std::string& path) { exportPicture(path); }, [this] { lessons_->leave(); },
           [this] { return lessons_->sceneName(); }, [this](const QString& path) { return lessons_->mayWrite(path); }},
          this)),
      debugView_(std::make_unique<DebugView>(*renderer_, *viewport_, document_)),
      menu_(new MenuBar(this)),
      lessons_(new LessonView(
          {this, document_, *editor_, *renderer_, *viewport_, *debugView_,
           ViewSwitches{[this] { return menu_->reflectionsAreShown(); }, [this] { return menu_->boxesAreShown(); },
                        [this](bool shown) { menu_->setReflectionsShown(shown); },
                        [this](bool shown) { menu_->setBoxesShown(shown); }},
           [this] { probeWidget_->cancel(); }, [this] { return models_; },
           [this](const LessonModels::List& models, const std::string& path) { showModels(models, path); }},
          std::string(BOXPROBE_DATA_DIR) + "/lessons", this)),
      status_(new StatusLine(statusBar())) {
  viewport_->setCamera([this] { return renderer_->renderer()->GetActiveCamera(); });
  viewport_->setProbeWidget(probeWidget_);
  renderer_->setEditable(true);
  setCentralWidget(viewport_);
  setAcceptDrops(true);
  resize(1440, 900);
  buildPanels();
  connectViews();
  connectMenu();
  connectWork();
  connectBaking();
  connectDebugView();
  connectMotion();
  connectLessons();
  documentChanged(Changes::all());
}

MainWindow::~MainWindow() {
  // The overlay and the scene hold GL objects of the viewport's context: they go first, while it is there.
  preview_->setWatched(false);
  viewport_->window3d()->MakeCurrent();
  debugView_->releaseGraphics();
  renderer_->releaseGraphics();
  overlay_.reset();
  renderer_.reset();
  delete viewport_;
}

void MainWindow::buildPanels() {
  probeList_ = new ProbeList(*editor_, {[this] {
                                          const double* target =
                                              renderer_->renderer()->GetActiveCamera()->GetFocalPoint();
                                          return glm::dvec3(target[0], target[1], target[2]);
                                        },
                                        [this] { return renderer_->bounds(); }});
  bakePanel_ = new BakePanel(*editor_, *renderer_, *scheduler_);
  probePanel_ = new ProbePanel(*editor_);
  capturePanel_ = new CapturePanel(*editor_);
  materialPanel_ = new MaterialPanel(*editor_);
  objectPanel_ = new ObjectPanel(*editor_);
  lightPanel_ = new LightPanel(*editor_);
  picturePanel_ = new PicturePanel(*editor_);

  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(6);
  for (QWidget* panel : {static_cast<QWidget*>(probeList_), static_cast<QWidget*>(bakePanel_),
                         static_cast<QWidget*>(probePanel_), static_cast<QWidget*>(capturePanel_),
                         static_cast<QWidget*>(materialPanel_), static_cast<QWidget*>(objectPanel_),
                         static_cast<QWidget*>(lightPanel_), static_cast<QWidget*>(picturePanel_)}) {
    layout->addWidget(panel);
  }
  layout->addStretch(1);

  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(kPanelWidth);

  // Six names do not fit side by side.
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East);
  auto* dock = new QDockWidget(tr("Probes"), this);
  dock->setObjectName("probes");
  dock->setWidget(scroll);
  dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
  addDockWidget(Qt::RightDockWidgetArea, dock);
  resizeDocks({dock}, {kPanelWidth}, Qt::Horizontal);
  menu_->addDockToggle(dock->toggleViewAction());
  buildPreviewDock(dock);
  buildDebugDocks(dock);
  buildCostDock(dock);
  buildFrameDock(dock);
  buildLessonDock();
}

void MainWindow::buildDebugDocks(QDockWidget* beside) {
  auto* scroll = new QScrollArea;
  scroll->setWidget(debugView_->panel());
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const auto dock = [&](const QString& title, const char* name, QWidget* content) {
    auto* made = new QDockWidget(title, this);
    made->setObjectName(name);
    made->setWidget(content);
    tabifyDockWidget(beside, made);
    menu_->addDockToggle(made->toggleViewAction());
    return made;
  };
  dock(tr("Debug"), "debug", scroll);
  QDockWidget* card = dock(tr("Explain"), "explain", debugView_->card());
  connect(debugView_.get(), &DebugView::toolChanged, card, [card](bool on) {
    if (!on) return;
    card->show();
    card->raise();
  });
  beside->raise();
}

void MainWindow::buildCostDock(QDockWidget* beside) {
  costPanel_ = new CostPanel(*editor_);
  auto* dock = new QDockWidget(tr("Run time against error"), this);
  dock->setObjectName("cost");
  dock->setWidget(costPanel_);
  tabifyDockWidget(beside, dock);
  connect(dock, &QDockWidget::visibilityChanged, costPanel_, &CostPanel::setWatched);
  connect(costPanel_, &CostPanel::message, status_, &StatusLine::showMessage);
  connect(costPanel_, &CostPanel::failed, status_, &StatusLine::showError);
  beside->raise();
  menu_->addDockToggle(dock->toggleViewAction());
}

void MainWindow::buildFrameDock(QDockWidget* beside) {
  framePanel_ = new FramePanel(*editor_, {[this] { return renderer_->frameReport(); },
                                          [this] {
                                            viewport_->window3d()->MakeCurrent();
                                            const int* size = viewport_->window3d()->GetSize();
                                            const auto lookups = renderer_->measureLookups(size[0], size[1]);
                                            scheduler_->requestRender();
                                            return lookups;
                                          }});
  auto* dock = new QDockWidget(tr("Frame"), this);
  dock->setObjectName("frame");
  dock->setWidget(framePanel_);
  tabifyDockWidget(beside, dock);
  connect(dock, &QDockWidget::visibilityChanged, framePanel_, &FramePanel::setWatched);
  connect(scheduler_, &RenderScheduler::rendered, framePanel_, &FramePanel::update);
  SurfaceViewPanel* views = debugView_->surfacePanel();
  const int lookups = *findSurfaceView("lookups");
  connect(framePanel_, &FramePanel::heatMapSwitched, views,
          [views, lookups](bool on) { views->choose(on ? lookups : 0); });
  connect(views, &SurfaceViewPanel::changed, framePanel_,
          [this, lookups](const SurfaceViewSettings& settings) { framePanel_->showHeatMap(settings.view == lookups); });
  beside->raise();
  menu_->addDockToggle(dock->toggleViewAction());
}

void MainWindow::buildLessonDock() {
  lessonDock_ = new QDockWidget(tr("Lessons"), this);
  lessonDock_->setObjectName("lessons");
  lessonDock_->setWidget(lessons_->panel());
  lessonDock_->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  addDockWidget(Qt::LeftDockWidgetArea, lessonDock_);
  resizeDocks({lessonDock_}, {kLessonWidth}, Qt::Horizontal);
  lessonDock_->hide();
  lessonDock_->installEventFilter(this);
  projector_ = new Projector(this, lessonDock_, lessons_->panel());
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  // A lesson whose text is gone would leave its scene behind.
  if (watched == lessonDock_ && event->type() == QEvent::Close) lessons_->leave();
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::connectLessons() {
  connect(menu_, &MenuBar::lessonsRequested, this, &MainWindow::showLessons);
  connect(menu_, &MenuBar::projectorSwitched, projector_, &Projector::setOn);
  connect(projector_, &Projector::switched, menu_, &MenuBar::showProjector);
  connect(lessons_, &LessonView::shown, this, [this] {
    lessonDock_->show();
    lessonDock_->raise();
  });
  connect(lessons_, &LessonView::openChanged, this, [this](bool open) {
    projector_->setLessonOpen(open);
    updateTitle();
  });
  connect(lessons_, &LessonView::pictureChanged, scheduler_, &RenderScheduler::requestRender);
  connect(lessons_, &LessonView::message, status_, &StatusLine::showMessage);
  connect(lessons_, &LessonView::failed, status_, &StatusLine::showError);
  connect(editor_.get(), &Editor::settled, lessons_, &LessonView::documentChanged);
  connect(scheduler_, &RenderScheduler::rendered, lessons_, &LessonView::pictureDrawn);
  connect(scheduler_, &RenderScheduler::workEnded, lessons_, &LessonView::workEnded);
  connect(viewport_, &Viewport::cameraMoved, lessons_, &LessonView::cameraMoved);
  connect(viewport_, &Viewport::becameReady, lessons_, &LessonView::shapeChanged);
}

void MainWindow::showLessons() {
  lessons_->showList();
}

void MainWindow::openLesson(const QString& name, std::optional<std::size_t> step) {
  lessons_->open(name, step);
}

void MainWindow::connectDebugView() {
  connect(menu_, &MenuBar::explainToolSwitched, debugView_.get(), &DebugView::setTool);
  connect(menu_, &MenuBar::copyTextRequested, debugView_.get(), &DebugView::copyText);
  connect(menu_, &MenuBar::copyJsonRequested, debugView_.get(), &DebugView::copyJson);
  connect(menu_, &MenuBar::saveRaysRequested, debugView_.get(), &DebugView::saveRays);
  connect(debugView_.get(), &DebugView::toolChanged, menu_, &MenuBar::showExplainTool);
  connect(debugView_.get(), &DebugView::pictureChanged, scheduler_, &RenderScheduler::requestRender);
  connect(debugView_.get(), &DebugView::message, status_, &StatusLine::showMessage);
  connect(debugView_.get(), &DebugView::failed, status_, &StatusLine::showError);
  connect(viewport_, &Viewport::cameraMoved, debugView_.get(), &DebugView::cameraMoved);
  connect(scheduler_, &RenderScheduler::workEnded, debugView_.get(), &DebugView::workEnded);
}

void MainWindow::buildPreviewDock(QDockWidget* beside) {
  preview_ = new ProbePreview(*editor_, *renderer_, [this] { viewport_->window3d()->MakeCurrent(); });
  auto* scroll = new QScrollArea;
  scroll->setWidget(preview_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* dock = new QDockWidget(tr("Cubemap"), this);
  dock->setObjectName("cubemap");
  dock->setWidget(scroll);
  dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
  tabifyDockWidget(beside, dock);
  connect(dock, &QDockWidget::visibilityChanged, preview_, &ProbePreview::setWatched);
  beside->raise();
  menu_->addDockToggle(dock->toggleViewAction());
}

void MainWindow::connectViews() {
  document_.addObserver([this](const Changes& changes) { documentChanged(changes); });
  connect(editor_.get(), &Editor::failed, status_, &StatusLine::showError);
  connect(editor_.get(), &Editor::settled, this, [this] {
    motion_->rest();
    renderer_->setInteractive(document_.previewing());
    menu_->update(document_);
    updateTitle();
    scheduler_->requestRender();
  });
  connect(files_, &FileCommands::message, status_, &StatusLine::showMessage);
  connect(probeWidget_, &ProbeWidget::hint, status_, &StatusLine::showMessage);
  connect(probeWidget_, &ProbeWidget::pictureChanged, scheduler_, &RenderScheduler::requestRender);
  connect(viewport_, &Viewport::cameraMoved, scheduler_, &RenderScheduler::requestRender);
  connect(viewport_, &Viewport::becameReady, scheduler_, &RenderScheduler::requestRender);
}

void MainWindow::connectMenu() {
  connect(menu_, &MenuBar::openRequested, files_, &FileCommands::open);
  connect(menu_, &MenuBar::saveRequested, files_, &FileCommands::save);
  connect(menu_, &MenuBar::saveAsRequested, files_, &FileCommands::saveAs);
  connect(menu_, &MenuBar::exportRequested, files_, &FileCommands::exportImage);
  connect(menu_, &MenuBar::quitRequested, this, &QWidget::close);
  connect(menu_, &MenuBar::undoRequested, this, [this] { editor_->undo(); });
  connect(menu_, &MenuBar::redoRequested, this, [this] { editor_->redo(); });
  connect(menu_, &MenuBar::addRequested, probeList_, &ProbeList::addProbe);
  connect(menu_, &MenuBar::duplicateRequested, probeList_, &ProbeList::duplicateProbe);
  connect(menu_, &MenuBar::deleteRequested, probeList_, &ProbeList::deleteProbe);
  connect(menu_, &MenuBar::escapePressed, this, [this] {
    if (probeWidget_->dragging()) return probeWidget_->cancel();
    if (projector_->on()) return projector_->setOn(false);
    if (!debugView_->unpin()) scheduler_->stopWork();
  });
  connect(menu_, &MenuBar::cameraChosen, this, &MainWindow::applyCamera);
  connect(menu_, &MenuBar::resetViewRequested, this, &MainWindow::resetView);
  connect(menu_, &MenuBar::boxesShown, probeWidget_, &ProbeWidget::setVisible);
  connect(menu_, &MenuBar::reflectionsShown, this, [this](bool shown) {
    renderer_->setProbesEnabled(shown);
    scheduler_->requestRender();
  });
  connect(menu_, &MenuBar::aboutRequested, this, [this] { showAbout(this); });
}

void MainWindow::connectWork() {
  connect(scheduler_, &RenderScheduler::workProgressed, status_, &StatusLine::showProgress);
  connect(scheduler_, &RenderScheduler::workEnded, this, [this] {
    status_->hideProgress(scheduler_->workStopped());
    if (firstPictureDone_ || renderer_->workPending()) return;
    firstPictureDone_ = true;
    emit firstPictureComplete();
  });
  connect(scheduler_, &RenderScheduler::rendered, this, [this] {
    status_->showCounters(renderer_->counters());
    status_->showPicture(renderer_->frameCount(), motion_->active());
    if (renderer_->error() == shownError_) return;
    shownError_ = renderer_->error();
    if (!shownError_.empty()) status_->showError(QString::fromStdString(shownError_));
  });
  connect(status_, &StatusLine::stopRequested, scheduler_, &RenderScheduler::stopWork);
  connect(status_, &StatusLine::resumeRequested, scheduler_, &RenderScheduler::resumeWork);
}

void MainWindow::connectBaking() {
  connect(menu_, &MenuBar::bakeRequested, bakePanel_, &BakePanel::bakeSelected);
  connect(menu_, &MenuBar::bakeAllRequested, bakePanel_, &BakePanel::bakeAll);
  connect(menu_, &MenuBar::saveBakedRequested, bakePanel_, &BakePanel::saveBaked);
  connect(bakePanel_, &BakePanel::statesChanged, probeList_, &ProbeList::showStates);
  connect(bakePanel_, &BakePanel::message, status_, &StatusLine::showMessage);
  connect(bakePanel_, &BakePanel::failed, status_, &StatusLine::showError);
  connect(preview_, &ProbePreview::pictureChanged, scheduler_, &RenderScheduler::requestRender);
  connect(scheduler_, &RenderScheduler::rendered, preview_, &ProbePreview::update);
  connect(menu_, &MenuBar::recentChosen, files_, &FileCommands::openPath, Qt::QueuedConnection);
  connect(files_, &FileCommands::recentChanged, menu_, &MenuBar::showRecent);
  menu_->showRecent(recentFiles());
}

void MainWindow::connectMotion() {
  connect(menu_, &MenuBar::motionPreviewSwitched, motion_, &MotionPreview::setEnabled);
  connect(motion_, &MotionPreview::enabledChanged, menu_, &MenuBar::showMotionPreview);
  connect(motion_, &MotionPreview::enabledChanged, scheduler_, &RenderScheduler::sceneChanged);
  connect(motion_, &MotionPreview::cameToRest, scheduler_, &RenderScheduler::requestRender);
  connect(viewport_, &Viewport::cameraMoved, motion_, &MotionPreview::moved);
  connect(viewport_, &Viewport::becameReady, this, [this] {
    if (viewport_->readyToDraw()) motion_->setDefault(viewport_->softwareRenderer());
  });
}

void MainWindow::documentChanged(const Changes& changes) {
  // While something is dragged the renderer puts off what only the final value needs: programs, further bounces.
  if (document_.previewing()) {
    motion_->moved();
    renderer_->setInteractive(true);
  }
  renderer_->sync(document_.scene(), changes);
  if (!document_.previewing()) renderer_->setInteractive(false);
  probeWidget_->update();
  probeList_->update();
  probePanel_->update();
  bakePanel_->update();
  capturePanel_->update();
  materialPanel_->update();
  objectPanel_->update();
  lightPanel_->update();
  picturePanel_->update();
  preview_->update();
  costPanel_->update();
  menu_->update(document_);
  debugView_->documentChanged(changes);
  lessons_->documentChanged();
  updateTitle();
  const bool empty = document_.scene().models.empty();
  viewport_->showInvitation(empty ? tr("Drop a scene or a model here, or open one with Ctrl+O.\nNew to reflection "
                                       "probes? F1 opens the lessons.")
                                  : QString());
  scheduler_->sceneChanged();
}

void MainWindow::updateTitle() {
  setWindowTitle(files_->displayName() + "[*] - Boxprobe");
  setWindowModified(document_.modified());
}

void MainWindow::showScene(LoadedScene loaded) {
  lessons_->drop();
  showModels(loaded.models, loaded.path);
  document_.open(std::move(loaded.scene), loaded.path);
  if (!document_.scene().probes.empty()) document_.selectProbe(0);
  resetView();
}

void MainWindow::showModels(const std::vector<std::shared_ptr<const Model>>& models, const std::string& path) {
  probeWidget_->cancel();
  models_ = models;
  renderer_->setModels(models);
  capturePanel_->setModels(models);
  materialPanel_->setModels(models);
  objectPanel_->setModels(models);
  debugView_->setModels(models);
  bakePanel_->useFilesBeside(path);
}

void MainWindow::resetView() {
  if (document_.scene().cameras.empty()) {
    renderer_->applyCamera(fittedCamera(renderer_->bounds()));
  } else {
    renderer_->applyCamera(document_.scene().cameras.front());
  }
  debugView_->cameraMoved();
  scheduler_->requestRender();
}

void MainWindow::applyCamera(int index) {
  const auto& cameras = document_.scene().cameras;
  if (static_cast<std::size_t>(index) >= cameras.size()) return;
  renderer_->applyCamera(cameras[static_cast<std::size_t>(index)]);
  debugView_->cameraMoved();
  scheduler_->requestRender();
}

template <typename Work>
void MainWindow::guarded(const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    scheduler_->stopWork();  // it would fail again at every turn
    status_->showError(QString::fromUtf8(error.what()));
  }
}

void MainWindow::drawPicture() {
  debugView_->update();
  overlay_->follow(viewport_->view());
  viewport_->window3d()->Render();
}

void MainWindow::exportPicture(const std::string& path) {
  viewport_->window3d()->MakeCurrent();
  motion_->rest();
  const bool linear = QString::fromStdString(path).endsWith(".exr", Qt::CaseInsensitive);
  constexpr int kExportSamples = 4;
  if (linear) {
    const int* size = viewport_->window3d()->GetSize();
    // Several samples a pixel have as many rays in as many frames fewer.
    const int frames = (renderer_->frameCount().wanted + kExportSamples - 1) / kExportSamples;
    saveExr(path, renderer_->renderLinear(size[0], size[1], kExportSamples, std::max(frames, 1)));
  } else {
    // What is saved is what is on the screen once it is at rest.
    for (int left = renderer_->frameCount().wanted; left > 0 && renderer_->frameCount().more(); --left) {
      viewport_->window3d()->Render();
    }
    const PreviewSphereSettings sphere = renderer_->previewSphere();
    renderer_->showPreviewSphere({});
    overlay_->setSuspended(true);
    const ImageRgba8 image = renderer_->renderDisplay();
    overlay_->setSuspended(false);
    renderer_->showPreviewSphere(sphere);
    savePng(path, image);
  }
  scheduler_->requestRender();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->confirmLeaving()) return event->ignore();
  emit closing();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!FileCommands::droppedFile(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = FileCommands::droppedFile(event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  files_->openPath(path);
}

}  // namespace boxprobe
