// See main_window.h.
#include "app/gui/window/main_window.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QStatusBar>
#include <utility>

#include "app/gui/explain/debug_view.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/lessons/lesson_panel.h"
#include "app/gui/lessons/lesson_view.h"
#include "app/gui/panels/bake_panel.h"
#include "app/gui/panels/fit_panel.h"
#include "app/gui/panels/outliner.h"
#include "app/gui/panels/place_panel.h"
#include "app/gui/panels/probe_commands.h"
#include "app/gui/view/animation_tools.h"
#include "app/gui/view/motion_preview.h"
#include "app/gui/view/picture_export.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/rest_refinement.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/accessible_names.h"
#include "app/gui/widgets/phrase_words.h"
#include "app/gui/widgets/place_keys.h"
#include "app/gui/widgets/preferences.h"
#include "app/gui/widgets/recent_files.h"
#include "app/gui/widgets/tool_icons.h"
#include "app/gui/widgets/window_style.h"
#include "app/gui/window/about_dialog.h"
#include "app/gui/window/autosave.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/lesson_dock.h"
#include "app/gui/window/live_link.h"
#include "app/gui/window/menu_bar.h"
#include "app/gui/window/model_fitter.h"
#include "app/gui/window/panel_docks.h"
#include "app/gui/window/probe_exporter.h"
#include "app/gui/window/projector.h"
#include "app/gui/window/scene_reporter.h"
#include "app/gui/window/status_line.h"
#include "app/gui/window/thumbnail_keeper.h"
#include "app/gui/window/view_tools.h"
#include "app/gui/window/welcome.h"
#include "app/session/opened_glb.h"
#include "filters/core/geometry/probe_at.h"
#include "filters/fit/rays/triangle_sight.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/files/data_folder.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

// The shadows of lamps drawn as shapes are traced by what fits boxes.
static std::unique_ptr<SceneRenderer> tracingRenderer(vtkOpenGLRenderWindow* window) {
  auto renderer = std::make_unique<SceneRenderer>(window);
  renderer->setSightLines(traceSightLines);
  return renderer;
}

MainWindow::MainWindow()
    : views_(document_),
      editor_(std::make_unique<Editor>(document_)),
      state_(std::make_unique<ViewState>()),
      viewport_(new Viewport(this)),
      renderer_(tracingRenderer(viewport_->window3d())),
      shownHandles_(vtkSmartPointer<vtkReflectionProbeRepresentation>::New()),
      surfaces_(std::make_unique<SceneSurfaces>(document_)),
      probeWidget_(new ProbeWidget(
          *editor_, *state_, *shownHandles_, *surfaces_, [this] { return viewport_->view(); }, this)),
      work_(new PictureWork(
          document_, *renderer_, *viewport_,
          [this] {
            debugView_->update();
            shownHandles_->Follow(viewport_->view());
          },
          this)),
      files_(new FileCommands(
          document_, *editor_,
          {[this](LoadedScene loaded) { showScene(std::move(loaded)); },
           [this](const std::string& path) {
             motionPreview().rest();
             tools_->showOwnScene();
             exportPicture(path, *renderer_, *viewport_, *shownHandles_);
             scheduler().requestRender();
           },
           [this] { lessons_->leave(); }, [this] { return lessons_->sceneName(); },
           [this](const QString& path) { return lessons_->mayWrite(path); }, [this] { return pictureAspect(); },
           [this](LoadedScene loaded) {
             const Camera view = renderer_->currentCamera();
             const Probe* selected = editor_->probe();
             const std::string name = selected != nullptr ? selected->name : std::string();
             showScene(std::move(loaded));
             if (const auto index = findProbe(document_.scene(), name)) document_.selectProbe(index);
             renderer_->applyCamera(view);
             emit viewport_->cameraMoved();
           }},
          this)),
      autosave_(new Autosave(
          document_, [this] { return lessons_->sceneName().isEmpty(); },
          [this] {
            return Autosave::About{files_->displayName(), files_->folderShown(), files_->digestAsRead()};
          },
          this)),
      exporter_(new ProbeExporter(document_, *renderer_, this)),
      liveLink_(new LiveLink(document_, *renderer_,
                             {[this] { return models_; }, [this] { return lessons_->sceneName().isEmpty(); }}, this)),
      reporter_(new SceneReporter(
          [this] {
            LoadedScene loaded;
            loaded.scene = document_.scene();
            loaded.models = models_;
            loaded.path = document_.path();
            return SceneReporter::Shown{std::move(loaded), renderer_->currentCamera(), files_->folderShown()};
          },
          this)),
      debugView_(std::make_unique<DebugView>(*renderer_, *viewport_, document_)),
      menu_(new MenuBar(this)),
      lessons_(new LessonView(
          {this, document_, *editor_, *renderer_, *viewport_, *debugView_,
           ViewSwitches{[this] { return menu_->reflectionsAreShown(); }, [this] { return menu_->boxesAreShown(); },
                        [this](bool shown) { menu_->setReflectionsShown(shown); },
                        [this](bool shown) { menu_->setBoxesShown(shown); }},
           [this] {
             probeWidget_->cancel();
             autosave_->write();  // a lesson is about to stand in its place
           },
           [this] { return models_; },
           [this](const LessonModels::List& models, const std::string& path) { showModels(models, path); }},
          dataFile("lessons"), this)),
      status_(new StatusLine(statusBar())),
      fitter_(
          new ModelFitter({document_, *editor_, *renderer_, [this]() -> const TriangleRays::Models& { return models_; },
                           [this] { return pictureAspect(); }, viewport_},
                          this)),
      animation_(new AnimationTools({document_, *editor_, [this]() -> const AnimationTools::Models& { return models_; },
                                     [this](const AnimationTools::Models& models) {
                                       takePose(models);
                                       views_.updateAll();
                                     },
                                     [this] { return probeWidget_->dragging(); }},
                                    this)),
      welcome_(new Welcome(viewport_, QString::fromStdString(dataFile("scenes")))),
      thumbnails_(new ThumbnailKeeper(
          {[this] {
             const bool own = lessons_->sceneName().isEmpty();
             return own ? QString::fromStdString(ownPathOf(document_.path(), document_.scene())) : QString();
           },
           [this] {
             const bool plain = renderer_->view().view == 0 && !state_->anyHidden() && !state_->isolated();
             return plain && viewport_->readyToDraw() && !renderer_->workPending() && !document_.previewing();
           },
           [this] { return viewport_->grabFramebuffer(); }},
          this)),
      panels_(new PanelDocks(this, {*editor_, *state_, *renderer_, *viewport_, scheduler(), *debugView_, *menu_})) {
  viewport_->setCamera([this] { return renderer_->renderer()->GetActiveCamera(); },
                       [this](const Ray& ray) { return surfaces_->meet(ray); }, [this] { return renderer_->bounds(); });
  shownHandles_->SetRenderer(renderer_->renderer());
  viewport_->setProbeWidget(probeWidget_);
  renderer_->setEditable(true);
  renderer_->showCoarseFirst(true);
  setCentralWidget(viewport_);
  setAcceptDrops(true);
  resize(1440, 900);
  setWindowIcon(toolIcon(ToolIcon::Box));
  lessonDock_ = new LessonDock(*lessons_, this);
  connectDocument();
  connectFiles();
  connectEditing();
  connectPicture();
  connectPanels();
  connectDebugView();
  connectLessons();
  connectFitter();
  connectWelcome();
  tools_ = new ViewTools({document_, *editor_, *state_, *renderer_, *viewport_, *shownHandles_, *probeWidget_,
                          *surfaces_, *menu_, *panels_, *debugView_, *status_, scheduler(), [this] { return models_; }},
                         this);
  tools_->subscribe(views_);
  connect(tools_, &ViewTools::automaticExposureWanted, fitter_, &ModelFitter::exposeAgain);
  views_.updateAll();
  nameControls(this);
}

MainWindow::~MainWindow() {
  // The handles and the scene hold GL objects of the viewport's context: they go first, while it is there.
  panels_->stopReading();
  delete tools_;  // its threads and its drawings over the picture
  tools_ = nullptr;
  delete lessonDock_;  // gives widths to docks as they are hidden, which they are while the window is half destroyed
  lessonDock_ = nullptr;
  viewport_->window3d()->MakeCurrent();
  debugView_->releaseGraphics();
  renderer_->releaseGraphics();
  shownHandles_->SetRenderer(nullptr);
  renderer_.reset();
  delete viewport_;
}

RenderScheduler& MainWindow::scheduler() {
  return work_->scheduler();
}

MotionPreview& MainWindow::motionPreview() {
  return work_->motion();
}

RestRefinement& MainWindow::refinement() {
  return work_->refinement();
}

Projector& MainWindow::projector() {
  return lessonDock_->projector();
}

// The renderer first, for views ask it; the scheduler last, for views show whether work was stopped until now.
void MainWindow::connectDocument() {
  views_.add("picture", ChangeKinds::all(), [this](const Changes& changes) { work_->syncScene(changes); });
  views_.add("surfaces", {&Changes::models, &Changes::objects},
             [this](const Changes& changes) { surfaces_->documentChanged(changes); });
  // A drag has nothing left to move once anything else was edited.
  views_.add("handles", ChangeKinds::all(), [this](const Changes&) { probeWidget_->update(); });
  panels_->subscribe(views_);
  views_.add("menu", ChangeKinds::all(), [this](const Changes&) { menu_->update(document_); });
  views_.add("debug view", ChangeKinds::all(),
             [this](const Changes& changes) { debugView_->documentChanged(changes); });
  views_.add("lessons", ChangeKinds::all(), [this](const Changes&) { lessons_->documentChanged(); });
  views_.add("title", {&Changes::file, &Changes::models}, [this](const Changes&) { updateTitle(); });
  views_.add("welcome", {&Changes::models}, [this](const Changes&) { updateWelcome(); });
  views_.add("unit", {&Changes::models}, [this](const Changes&) { fitter_->modelsChanged(); });
  views_.add("animation", {&Changes::models}, [this](const Changes&) { animation_->modelsChanged(); });
  views_.add("work", ChangeKinds::all(), [this](const Changes&) { scheduler().sceneChanged(); });
  connect(editor_.get(), &Editor::failed, status_, &StatusLine::showError);
  connect(editor_.get(), &Editor::settled, this, [this] {
    menu_->update(document_);
    updateTitle();
  });
  connect(editor_.get(), &Editor::settled, work_, &PictureWork::editSettled);
  connect(editor_.get(), &Editor::settled, autosave_, &Autosave::settled);
  views_.add("autosave", {&Changes::file}, [this](const Changes&) { autosave_->settled(); });  // saved, opened
  connect(autosave_, &Autosave::failed, status_, &StatusLine::showError);
  connect(editor_.get(), &Editor::settled, liveLink_, &LiveLink::changed);
  views_.add("live link", {&Changes::file, &Changes::models}, [this](const Changes&) { liveLink_->changed(); });
}

void MainWindow::connectFiles() {
  connect(menu_, &MenuBar::openRequested, files_, &FileCommands::open);
  connect(menu_, &MenuBar::reloadRequested, files_, &FileCommands::reload);
  connect(menu_, &MenuBar::skyRequested, files_, &FileCommands::chooseSky);
  connect(menu_, &MenuBar::saveRequested, files_, &FileCommands::save);
  connect(menu_, &MenuBar::saveAsRequested, files_, &FileCommands::saveAs);
  connect(menu_, &MenuBar::exportRequested, files_, &FileCommands::exportImage);
  connect(menu_, &MenuBar::exportProbesRequested, exporter_, &ProbeExporter::ask);
  connect(exporter_, &ProbeExporter::ownSceneWanted, this, [this] { tools_->showOwnScene(); });
  connect(exporter_, &ProbeExporter::message, status_, &StatusLine::showMessage);
  connect(exporter_, &ProbeExporter::failed, status_, &StatusLine::showError);
  connect(menu_, &MenuBar::liveLinkRequested, liveLink_, &LiveLink::ask);
  connect(liveLink_, &LiveLink::switched, menu_, &MenuBar::showLiveLink);
  connect(liveLink_, &LiveLink::message, status_, &StatusLine::showMessage);
  connect(liveLink_, &LiveLink::failed, status_, &StatusLine::showError);
  connect(menu_, &MenuBar::reportRequested, reporter_, &SceneReporter::ask);
  connect(reporter_, &SceneReporter::message, status_, &StatusLine::showMessage);
  connect(reporter_, &SceneReporter::failed, status_, &StatusLine::showError);
  connect(menu_, &MenuBar::quitRequested, this, &QWidget::close);
  connect(menu_, &MenuBar::recentChosen, files_, &FileCommands::openPath, Qt::QueuedConnection);
  // Later: the menu is made anew by what it brings about.
  connect(menu_, &MenuBar::variantChosen, files_, &FileCommands::openVariant, Qt::QueuedConnection);
  connect(files_, &FileCommands::recentChanged, menu_, &MenuBar::showRecent);
  connect(files_, &FileCommands::message, status_, &StatusLine::showMessage);
  menu_->showRecent(recentFiles());
}

void MainWindow::connectEditing() {
  connect(menu_, &MenuBar::undoRequested, editor_.get(), &Editor::undo);
  connect(menu_, &MenuBar::redoRequested, editor_.get(), &Editor::redo);
  connect(menu_, &MenuBar::historyChosen, editor_.get(), [this](int position) { editor_->goTo(position); });
  connect(menu_, &MenuBar::addRequested, &panels_->probeCommands(), &ProbeCommands::addProbe);
  connect(menu_, &MenuBar::duplicateRequested, &panels_->outliner(), &Outliner::duplicateSelected);
  connect(menu_, &MenuBar::deleteRequested, &panels_->outliner(), &Outliner::deleteSelected);
  connect(menu_, &MenuBar::escapePressed, this, &MainWindow::escape);
  connect(menu_, &MenuBar::handleModeChosen, probeWidget_, &ProbeWidget::setMode);
  connect(probeWidget_, &ProbeWidget::modeChanged, menu_, &MenuBar::showHandleMode);
  connect(menu_, &MenuBar::boxesShown, probeWidget_, &ProbeWidget::setVisible);
  menu_->showTheme(chosenTheme().value_or(static_cast<int>(Theme::System)));
  connect(menu_, &MenuBar::themeChosen, this, [](int theme) {
    keepTheme(theme);
    applyWindowStyle(*qApp, static_cast<Theme>(theme));
  });
  connect(menu_, &MenuBar::aboutRequested, this, [this] { showAbout(this); });
  connect(probeWidget_, &ProbeWidget::hint, status_, &StatusLine::showMessage);
  connect(probeWidget_, &ProbeWidget::pictureChanged, &scheduler(), &RenderScheduler::requestRender);
}

void MainWindow::connectPicture() {
  connect(menu_, &MenuBar::cameraChosen, work_, &PictureWork::showCamera);
  connect(menu_, &MenuBar::resetViewRequested, work_, &PictureWork::resetCamera);
  connect(menu_, &MenuBar::reflectionsShown, work_, &PictureWork::setReflectionsShown);
  connect(menu_, &MenuBar::motionPreviewSwitched, &motionPreview(), &MotionPreview::setEnabled);
  connect(&motionPreview(), &MotionPreview::enabledChanged, menu_, &MenuBar::showMotionPreview);
  RestRefinement& refinement = work_->refinement();
  work_->setPlainWhere([this] { return !lessons_->sceneName().isEmpty(); });
  menu_->showRefinement(refinement.enabled());
  connect(menu_, &MenuBar::refinementSwitched, &refinement, &RestRefinement::setEnabled);
  connect(&refinement, &RestRefinement::enabledChanged, menu_, &MenuBar::showRefinement);
  connect(work_, &PictureWork::failed, status_, &StatusLine::showError);
  connect(work_, &PictureWork::firstPictureComplete, this, &MainWindow::firstPictureComplete);
  connect(&scheduler(), &RenderScheduler::workProgressed, status_,
          [this](double fraction) { status_->showProgress(fraction, renderer_->workNow()); });
  connect(&scheduler(), &RenderScheduler::workEnded, status_,
          [this] { status_->hideProgress(scheduler().workStopped()); });
  connect(&scheduler(), &RenderScheduler::rendered, status_, [this] {
    status_->showCounters(renderer_->counters());
    status_->showPicture(renderer_->frameCount(), motionPreview().active());
  });
  connect(status_, &StatusLine::stopRequested, &scheduler(), &RenderScheduler::stopWork);
  connect(status_, &StatusLine::resumeRequested, &scheduler(), &RenderScheduler::resumeWork);
}

void MainWindow::connectPanels() {
  connect(menu_, &MenuBar::fitRequested, &panels_->fitPanel(), &FitPanel::fit);
  connect(menu_, &MenuBar::placeRequested, &panels_->placePanel(), &PlacePanel::place);
  connect(panels_, &PanelDocks::ghostsChanged, this, [this](const std::vector<Probe>& ghosts) {
    shownHandles_->ShowGhosts(ghosts);
    scheduler().requestRender();
  });
  connect(menu_, &MenuBar::bakeRequested, &panels_->bakePanel(), &BakePanel::bakeSelected);
  connect(menu_, &MenuBar::bakeAllRequested, &panels_->bakePanel(), &BakePanel::bakeAll);
  connect(menu_, &MenuBar::saveBakedRequested, &panels_->bakePanel(), &BakePanel::saveBaked);
  connect(panels_, &PanelDocks::pictureChanged, &scheduler(), &RenderScheduler::requestRender);
  connect(panels_, &PanelDocks::message, status_, &StatusLine::showMessage);
  connect(panels_, &PanelDocks::failed, status_, &StatusLine::showError);
}

void MainWindow::connectDebugView() {
  connect(menu_, &MenuBar::explainToolSwitched, debugView_.get(), &DebugView::setTool);
  connect(menu_, &MenuBar::copyTextRequested, debugView_.get(), &DebugView::copyText);
  connect(menu_, &MenuBar::copyJsonRequested, debugView_.get(), &DebugView::copyJson);
  connect(menu_, &MenuBar::saveRaysRequested, debugView_.get(), &DebugView::saveRays);
  connect(debugView_.get(), &DebugView::toolChanged, menu_, &MenuBar::showExplainTool);
  connect(debugView_.get(), &DebugView::mendRequested, this, [this](const Mend& mend) {
    editor_->commit(phraseWords(mend.words), [mend](Scene& scene) {
      if (const auto index = findProbe(scene, mend.probe)) scene.probes[*index] = mend.after;
    });
  });
  connect(debugView_.get(), &DebugView::pictureChanged, &scheduler(), &RenderScheduler::requestRender);
  connect(debugView_.get(), &DebugView::message, status_, &StatusLine::showMessage);
  connect(debugView_.get(), &DebugView::failed, status_, &StatusLine::showError);
  connect(viewport_, &Viewport::cameraMoved, debugView_.get(), &DebugView::cameraMoved);
  connect(work_, &PictureWork::cameraPlaced, debugView_.get(), &DebugView::cameraMoved);
  connect(&scheduler(), &RenderScheduler::workEnded, debugView_.get(), &DebugView::workEnded);
}

void MainWindow::connectLessons() {
  connect(menu_, &MenuBar::lessonsRequested, this, &MainWindow::toggleLessons);
  connect(menu_, &MenuBar::projectorSwitched, &projector(), &Projector::setOn);
  connect(&projector(), &Projector::switched, menu_, &MenuBar::showProjector);
  connect(lessons_, &LessonView::openChanged, this, &MainWindow::updateTitle);
  // A lesson's room is wrong on purpose, and the lesson says how.
  connect(lessons_, &LessonView::openChanged, this,
          [this] { panels_->fitPanel().setQuiet(!lessons_->sceneName().isEmpty()); });
  connect(lessons_, &LessonView::pictureChanged, &scheduler(), &RenderScheduler::requestRender);
  connect(lessons_, &LessonView::message, status_, &StatusLine::showMessage);
  connect(lessons_, &LessonView::failed, status_, &StatusLine::showError);
  connect(editor_.get(), &Editor::settled, lessons_, &LessonView::documentChanged);
  connect(&scheduler(), &RenderScheduler::rendered, lessons_, &LessonView::pictureDrawn);
  connect(&scheduler(), &RenderScheduler::workEnded, lessons_, &LessonView::workEnded);
  connect(viewport_, &Viewport::cameraMoved, lessons_, &LessonView::cameraMoved);
  connect(viewport_, &Viewport::becameReady, lessons_, &LessonView::shapeChanged);
}

void MainWindow::connectFitter() {
  connect(fitter_, &ModelFitter::message, status_, &StatusLine::showMessage);
  connect(fitter_, &ModelFitter::failed, status_, &StatusLine::showError);
  connect(fitter_, &ModelFitter::cameraFitted, work_, &PictureWork::resetCamera);
  connect(fitter_, &ModelFitter::pictureWanted, &scheduler(), &RenderScheduler::requestRender);
  connect(&scheduler(), &RenderScheduler::rendered, fitter_, &ModelFitter::pictureDrawn);
  connect(lessons_, &LessonView::openChanged, fitter_, &ModelFitter::setBorrowed);
  connect(lessons_, &LessonView::openChanged, animation_, &AnimationTools::setBorrowed);
  connect(animation_, &AnimationTools::failed, status_, &StatusLine::showError);
}

double MainWindow::pictureAspect() const {
  return viewport_->height() > 0 ? static_cast<double>(viewport_->width()) / viewport_->height() : 1.0;
}

void MainWindow::showLessons() {
  lessons_->showList();
}

void MainWindow::toggleLessons() {
  // From a lesson's page back to the list first.
  if (lessons_->panel()->stepShown() || !lessonDock_->close()) showLessons();
}

void MainWindow::openLesson(const QString& name, std::optional<std::size_t> step) {
  lessons_->open(name, step);
}

// What is nearest at hand ends first.
void MainWindow::escape() {
  if (probeWidget_->dragging()) return probeWidget_->cancel();
  if (projector().on()) return projector().setOn(false);
  if (tools_->stopComparing()) return;
  if (!debugView_->unpin()) scheduler().stopWork();
}

void MainWindow::updateTitle() {
  const QString folder = files_->folderShown();
  // "[*]" is where Qt marks changes; in a name it is written twice.
  setWindowTitle(files_->displayName().replace("[*]", "[*][*]") + "[*] - " +
                 (folder.isEmpty() ? QString() : QString(folder).replace("[*]", "[*][*]") + " - ") + "Boxprobe");
  setWindowModified(document_.modified());
}

void MainWindow::connectWelcome() {
  connect(welcome_, &Welcome::openRequested, files_, &FileCommands::open);
  connect(welcome_, &Welcome::modelRequested, files_, &FileCommands::openModel);
  connect(welcome_, &Welcome::lessonsRequested, this, &MainWindow::showLessons);
  // Later: the cards are made anew.
  connect(welcome_, &Welcome::chosen, files_, &FileCommands::openPath, Qt::QueuedConnection);
  connect(files_, &FileCommands::recentChanged, thumbnails_, &ThumbnailKeeper::opened);
}

void MainWindow::updateWelcome() {
  const bool empty = document_.scene().models.empty();
  if (empty && !welcome_->isVisibleTo(viewport_)) welcome_->setRecent(recentFiles());
  welcome_->setVisible(empty);
}

void MainWindow::showScene(LoadedScene loaded) {
  lessons_->drop();
  showModels(loaded.models, ownPathOf(loaded.path, loaded.scene));
  QStringList variants;
  for (const std::string& name : loaded.models.empty() ? std::vector<std::string>() : loaded.models.front()->variants) {
    variants.append(QString::fromStdString(name));
  }
  const auto& files = loaded.scene.models;
  menu_->showVariants(variants, files.empty() ? QString() : QString::fromStdString(files.front().variant));
  document_.open(loaded.scene, loaded.path, loaded.unsaved);
  animation_->opened();
  fitter_->opened(loaded);
  work_->resetCamera();
  document_.selectProbe(probeNearest(document_.scene().probes, renderer_->currentCamera().position));
}

void MainWindow::showModels(const std::vector<std::shared_ptr<const Model>>& models, const std::string& path) {
  animation_->forget();
  probeWidget_->cancel();
  // Names of another scene mean others; those of one that is read again are the same.
  if (path != shownPath_) state_->forget();
  shownPath_ = path;
  panels_->setModels(models);
  takePose(models);
  // A .glb with probes has its baked files in itself; beside another model there are none.
  panels_->bakePanel().sceneOpened(isModelPath(path) && !holdsProbes(path) ? std::string() : path);
}

void MainWindow::takePose(const std::vector<std::shared_ptr<const Model>>& models) {
  models_ = models;
  surfaces_->setModels(models);
  renderer_->setModels(models);
  debugView_->setModels(models);
  if (tools_ != nullptr) tools_->modelsReplaced();
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  const int key = keyByPlace(*event);
  if (key == event->key()) return QMainWindow::keyPressEvent(event);
  const QKeySequence wanted(static_cast<int>(event->modifiers() & ~Qt::GroupSwitchModifier) | key);
  const auto actions = findChildren<QAction*>();
  for (QAction* action : actions) {
    if (!action->isEnabled() || !action->shortcuts().contains(wanted)) continue;
    if (!event->isAutoRepeat() || action->autoRepeat()) action->trigger();
    return event->accept();
  }
  QMainWindow::keyPressEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->confirmLeaving()) return event->ignore();
  emit closing();
  if (!projector().on()) keepWindowLayout(saveGeometry(), saveState());
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QMimeData* dropped = event->mimeData();
  const bool sky = !FileCommands::droppedSky(dropped).isEmpty();
  if (sky || !FileCommands::droppedFile(dropped).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = FileCommands::droppedFile(event->mimeData());
  const QString sky = FileCommands::droppedSky(event->mimeData());
  if (path.isEmpty() && sky.isEmpty()) return;
  event->acceptProposedAction();
  if (path.isEmpty()) return files_->openSky(sky);
  files_->openPath(path);
}

}  // namespace boxprobe
