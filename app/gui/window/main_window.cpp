// See main_window.h.
#include "app/gui/window/main_window.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QAction>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QStatusBar>

#include "app/gui/explain/debug_view.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/lessons/lesson_view.h"
#include "app/gui/view/animation_tools.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/accessible_names.h"
#include "app/gui/widgets/place_keys.h"
#include "app/gui/widgets/preferences.h"
#include "app/gui/widgets/recent_files.h"
#include "app/gui/widgets/tool_icons.h"
#include "app/gui/window/autosave.h"
#include "app/gui/window/camera_menu.h"
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
#include "filters/io/files/data_folder.h"

namespace boxprobe {

// What lies over the picture, and the focus, follow the order in which parts are made.
MainWindow::MainWindow()
    : workspace_(this),
      files_(new FileCommands(workspace_, this)),
      autosave_(new Autosave(workspace_, this)),
      exporter_(new ProbeExporter(workspace_, this)),
      liveLink_(new LiveLink(workspace_, this)),
      reporter_(new SceneReporter(workspace_, this)),
      debugView_(std::make_unique<DebugView>(workspace_)) {
  setCentralWidget(&workspace_.viewport());
  setAcceptDrops(true);
  resize(1440, 900);
  setWindowIcon(toolIcon(ToolIcon::Box));
  new MenuBar(workspace_, this);
  new CameraMenu(workspace_, this);
  lessons_ = new LessonView(workspace_, *debugView_, dataFile("lessons"), this);
  new StatusLine(workspace_, statusBar());
  fitter_ = new ModelFitter(workspace_, this);
  new AnimationTools(workspace_, this);
  welcome_ = new Welcome(&workspace_.viewport(), QString::fromStdString(dataFile("scenes")));
  new ThumbnailKeeper(workspace_, this);
  panels_ = new PanelDocks(workspace_, *debugView_, this);
  lessonDock_ = new LessonDock(workspace_, *lessons_, this);
  tools_ = new ViewTools(workspace_, this);
  observeWelcome();
  workspace_.changes().add("title", {&Changes::file, &Changes::models}, [this](const Changes&) { updateTitle(); });
  connect(&workspace_.editor(), &Editor::settled, this, &MainWindow::updateTitle);
  connect(&workspace_, &Workspace::lessonShown, this, &MainWindow::updateTitle);
  connect(workspace_.actions().escape, &QAction::triggered, this, &MainWindow::escape);
  connect(&workspace_.picture(), &PictureWork::firstPictureComplete, this, &MainWindow::firstPictureComplete);
  workspace_.begin();
  nameControls(this);
}

MainWindow::~MainWindow() {
  panels_->stopReading();
  delete tools_;       // its threads and its drawings over the picture
  delete lessonDock_;  // gives widths to docks as they are hidden, which they are while the window is half destroyed
  workspace_.viewport().window3d()->MakeCurrent();
  debugView_->releaseGraphics();
}

MotionPreview& MainWindow::motionPreview() {
  return workspace_.picture().motion();
}

RestRefinement& MainWindow::refinement() {
  return workspace_.picture().refinement();
}

Projector& MainWindow::projector() {
  return lessonDock_->projector();
}

void MainWindow::showLessons() {
  lessons_->showList();
}

void MainWindow::openLesson(const QString& name, std::optional<std::size_t> step) {
  lessons_->open(name, step);
}

// What is nearest at hand ends first.
void MainWindow::escape() {
  if (workspace_.handles().dragging()) return workspace_.handles().cancel();
  if (projector().on()) return projector().setOn(false);
  if (tools_->stopComparing()) return;
  if (!debugView_->unpin()) workspace_.scheduler().stopWork();
}

void MainWindow::updateTitle() {
  // "[*]" is where Qt marks changes; in a name it is written twice.
  const auto plain = [](QString text) { return text.replace("[*]", "[*][*]"); };
  const QString folder = workspace_.folderShown();
  setWindowTitle(plain(workspace_.displayName()) + "[*] - " + (folder.isEmpty() ? QString() : plain(folder) + " - ") +
                 "Boxprobe");
  setWindowModified(workspace_.document().modified());
}

void MainWindow::observeWelcome() {
  connect(welcome_, &Welcome::openRequested, files_, &FileCommands::open);
  connect(welcome_, &Welcome::modelRequested, files_, &FileCommands::openModel);
  connect(welcome_, &Welcome::lessonsRequested, this, &MainWindow::showLessons);
  // Later: the cards are made anew.
  connect(welcome_, &Welcome::chosen, files_, &FileCommands::openPath, Qt::QueuedConnection);
  workspace_.changes().add("welcome", {&Changes::models}, [this](const Changes&) { updateWelcome(); });
}

void MainWindow::updateWelcome() {
  const bool empty = workspace_.document().scene().models.empty();
  if (empty) welcome_->setRecent(recentFiles());
  welcome_->setVisible(empty);
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
