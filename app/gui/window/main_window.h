// Puts the window together: constructs the document's views and connects them. Decides nothing else. Called by
// runWindow and by tests.
#pragma once

#include <vtkSmartPointer.h>

#include <QMainWindow>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/edit/change_views.h"
#include "app/gui/edit/editor.h"
#include "app/gui/edit/view_state.h"
#include "app/session/load_scene.h"
#include "filters/core/scene/document.h"

class vtkReflectionProbeRepresentation;

namespace boxprobe {

class Autosave;
class DebugView;
class FileCommands;
class LessonDock;
class LessonView;
class MenuBar;
class AnimationTools;
class ModelFitter;
class MotionPreview;
class PanelDocks;
class PictureWork;
class LiveLink;
class ProbeExporter;
class ProbeWidget;
class Projector;
class RenderScheduler;
class RestRefinement;
class SceneReporter;
class SceneRenderer;
class SceneSurfaces;
class StatusLine;
class ThumbnailKeeper;
class ViewTools;
class Viewport;
class Welcome;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow();
  ~MainWindow() override;

  /// Shows a scene that was read, from its first camera.
  void showScene(LoadedScene loaded);

  /// The list of lessons beside the picture; the scene on show stays.
  void showLessons();
  /// The same, or away with the list where it is on show.
  void toggleLessons();
  /// A lesson, from that step (0 the first) or where the learner left off. The scene on show comes back afterwards.
  void openLesson(const QString& name, std::optional<std::size_t> step = {});

  Document& document() { return document_; }
  Editor& editor() { return *editor_; }
  ViewState& viewState() { return *state_; }
  Viewport& viewport() { return *viewport_; }
  ProbeWidget& probeWidget() { return *probeWidget_; }
  RenderScheduler& scheduler();
  FileCommands& files() { return *files_; }
  Autosave& autosave() { return *autosave_; }
  ProbeExporter& exporter() { return *exporter_; }
  LiveLink& liveLink() { return *liveLink_; }
  SceneReporter& reporter() { return *reporter_; }
  DebugView& debugView() { return *debugView_; }
  LessonView& lessons() { return *lessons_; }
  Projector& projector();
  ModelFitter& modelFitter() { return *fitter_; }
  MotionPreview& motionPreview();
  RestRefinement& refinement();
  PictureWork& pictureWork() { return *work_; }
  ViewTools& tools() { return *tools_; }
  /// Who is told of which changes of the document.
  const ChangeViews& views() const { return views_; }
  const SceneRenderer& renderer() const { return *renderer_; }
  /// On show, in the order of scene.models.
  const std::vector<std::shared_ptr<const Model>>& models() const { return models_; }

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
  void connectDocument();
  void connectFiles();
  void connectEditing();
  void connectPicture();
  void connectPanels();
  void connectDebugView();
  void connectLessons();
  void connectFitter();
  /// `path`: what the scene goes by (ownPathOf()); empty for a lesson's.
  void showModels(const std::vector<std::shared_ptr<const Model>>& models, const std::string& path);
  /// The same models in another pose.
  void takePose(const std::vector<std::shared_ptr<const Model>>& models);
  void escape();
  void updateTitle();
  void connectWelcome();
  void updateWelcome();
  double pictureAspect() const;  ///< width over height

  Document document_;
  ChangeViews views_;
  std::unique_ptr<Editor> editor_;
  std::unique_ptr<ViewState> state_;
  Viewport* viewport_;
  std::unique_ptr<SceneRenderer> renderer_;
  vtkSmartPointer<vtkReflectionProbeRepresentation> shownHandles_;
  std::unique_ptr<SceneSurfaces> surfaces_;
  ProbeWidget* probeWidget_;
  PictureWork* work_;
  FileCommands* files_;
  Autosave* autosave_;
  ProbeExporter* exporter_;
  LiveLink* liveLink_;
  SceneReporter* reporter_;
  std::unique_ptr<DebugView> debugView_;
  MenuBar* menu_;
  LessonView* lessons_;
  StatusLine* status_;
  ModelFitter* fitter_;
  AnimationTools* animation_;
  Welcome* welcome_;  ///< over the picture while no scene is open
  ThumbnailKeeper* thumbnails_;
  PanelDocks* panels_;
  ViewTools* tools_ = nullptr;
  LessonDock* lessonDock_;
  std::vector<std::shared_ptr<const Model>> models_;
  std::string shownPath_;  ///< what the scene on show goes by
};

}  // namespace boxprobe
