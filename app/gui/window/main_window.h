// The window: the workspace, the parts that share it, and where they stand.
#pragma once

#include <QMainWindow>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/view/workspace.h"

namespace boxprobe {

class Autosave;
class DebugView;
class FileCommands;
class LessonDock;
class LessonView;
class LiveLink;
class ModelFitter;
class MotionPreview;
class PanelDocks;
class ProbeExporter;
class Projector;
class RestRefinement;
class SceneReporter;
class ViewTools;
class Welcome;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow();
  ~MainWindow() override;

  /// Shows a scene that was read, from its first camera.
  void showScene(const LoadedScene& loaded) { workspace_.showScene(loaded); }

  /// The list of lessons beside the picture; the scene on show stays.
  void showLessons();
  /// A lesson, from that step (0 the first) or where the learner left off. The scene on show comes back afterwards.
  void openLesson(const QString& name, std::optional<std::size_t> step = {});

  Document& document() { return workspace_.document(); }
  Editor& editor() { return workspace_.editor(); }
  ViewState& viewState() { return workspace_.state(); }
  Viewport& viewport() { return workspace_.viewport(); }
  ProbeWidget& probeWidget() { return workspace_.handles(); }
  PictureWork& pictureWork() { return workspace_.picture(); }
  RenderScheduler& scheduler() { return workspace_.scheduler(); }
  MotionPreview& motionPreview();
  RestRefinement& refinement();
  const SceneRenderer& renderer() const { return workspace_.renderer(); }
  /// On show, in the order of scene.models.
  const Workspace::Models& models() const { return workspace_.models(); }
  /// Who is told of which changes of the document.
  const ChangeViews& views() { return workspace_.changes(); }
  FileCommands& files() { return *files_; }
  Autosave& autosave() { return *autosave_; }
  ProbeExporter& exporter() { return *exporter_; }
  LiveLink& liveLink() { return *liveLink_; }
  SceneReporter& reporter() { return *reporter_; }
  DebugView& debugView() { return *debugView_; }
  LessonView& lessons() { return *lessons_; }
  Projector& projector();
  ModelFitter& modelFitter() { return *fitter_; }
  ViewTools& tools() { return *tools_; }

 signals:
  /// Before anything is torn down; `renderer` and its GL context still live.
  void closing();
  /// The first picture with all captures done is on the screen.
  void firstPictureComplete();

 protected:
  void closeEvent(QCloseEvent* event) override;
  /// Shortcuts by the place of their key, where the layout has something else there.
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void escape();
  void updateTitle();
  void observeWelcome();
  void updateWelcome();

  Workspace workspace_;
  FileCommands* files_;
  Autosave* autosave_;
  ProbeExporter* exporter_;
  LiveLink* liveLink_;
  SceneReporter* reporter_;
  std::unique_ptr<DebugView> debugView_;
  LessonView* lessons_;
  ModelFitter* fitter_;
  Welcome* welcome_;  ///< over the picture while no scene is open
  PanelDocks* panels_;
  LessonDock* lessonDock_;
  ViewTools* tools_;
};

}  // namespace boxprobe
