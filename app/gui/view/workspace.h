// What the parts of the window share: the document and its edits, the picture, the models on show, what a user can do.
// Each part is given the workspace and connects itself to what it observes.
#pragma once

#include <vtkSmartPointer.h>

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/edit/change_views.h"
#include "app/gui/edit/editor.h"
#include "app/gui/edit/view_state.h"
#include "app/gui/widgets/actions.h"
#include "app/session/load_scene.h"
#include "filters/core/scene/document.h"

class QMainWindow;
class vtkReflectionProbeRepresentation;

namespace boxprobe {

class PictureWork;
class ProbeWidget;
class RenderScheduler;
class SceneRenderer;
class SceneSurfaces;
class ShownParts;
class ViewCommands;
class Viewport;
struct Lesson;

class Workspace : public QObject {
  Q_OBJECT

 public:
  using Models = std::vector<std::shared_ptr<const Model>>;

  explicit Workspace(QMainWindow* window);
  /// After all parts.
  ~Workspace() override;
  /// All parts are there: everything is new to them.
  void begin();

  Actions& actions() const { return *actions_; }
  Document& document() { return document_; }
  ChangeViews& changes() { return changes_; }
  Editor& editor() { return editor_; }
  ViewState& state() { return state_; }
  Viewport& viewport() const { return *viewport_; }
  SceneRenderer& renderer() const { return *renderer_; }
  SceneSurfaces& surfaces() const { return *surfaces_; }
  /// As they are drawn, and as the mouse has them.
  vtkReflectionProbeRepresentation& shownHandles() const;
  ProbeWidget& handles() const { return *handles_; }
  PictureWork& picture() const { return *picture_; }
  RenderScheduler& scheduler() const;
  ViewCommands& views() const { return *views_; }
  ShownParts& shown() const { return *shown_; }

  /// On show, in the order of scene.models.
  const Models& models() const { return models_; }
  /// Names of all objects in them.
  const ViewState::Names& nodes() const { return nodes_; }
  /// Of the picture: width over height.
  double aspect() const;
  /// Nothing is left to capture or to draw.
  bool atRest() const;
  void requestPicture();
  /// `place` is called with the view as it will be drawn, for what lies over the scene. What it throws is told.
  void setBeforePicture(std::function<void()> place) { beforePicture_ = std::move(place); }

  /// A scene that was read becomes the one on show, seen from its first camera.
  void showScene(const LoadedScene& loaded);
  /// Models of another scene, of which the document is told next. `path`: what that goes by (ownPathOf()); empty for a
  /// lesson's.
  void showModels(const Models& models, const std::string& path);
  /// The same models in another pose.
  void takePose(const Models& models);
  const std::string& shownPath() const { return shownPath_; }

  /// Whose scene stands in place of the user's own; null: the own one is on show.
  const Lesson* lesson() const { return lesson_; }
  void setLesson(const Lesson* lesson) { lesson_ = lesson; }
  /// A drag ends, and what is unsaved is kept: another scene is about to be shown.
  void prepareForAnother();

  /// Name of what is open, for the title: the lesson's, the file's, or the model's of a scene never saved.
  QString displayName() const;
  /// Of the scene's file, or of the model of a scene never saved; empty where neither is.
  QString folder() const;
  /// The same as it is shown: none while a lesson is.
  QString folderShown() const;
  /// fileDigest() of the scene's file as it was read or saved; empty: there was none, or it is not known.
  const std::string& digestAsRead() const { return digestAsRead_; }
  void setDigestAsRead(const std::string& digest) { digestAsRead_ = digest; }
  /// How the bare model on show was fitted; null: a scene is on show.
  const std::shared_ptr<const ModelFit>& fit() const { return fit_; }
  void setFit(std::shared_ptr<const ModelFit> fit) { fit_ = std::move(fit); }

  /// What a part says is for the line under the picture.
  template <typename Part>
  void listenTo(const Part* part) {
    connect(part, &Part::message, this, &Workspace::message);
    connect(part, &Part::failed, this, &Workspace::failed);
  }

 signals:
  void message(const QString& text);
  void failed(const QString& line);

  /// Another scene takes over; whatever was shown in place of the one before is given up.
  void opening();
  /// It is on show, and the document holds it.
  void opened(const boxprobe::LoadedScene& loaded);
  /// Its file was read or saved.
  void filed();
  /// Models of another scene are on show.
  void modelsReplaced();
  /// The same, or other poses of those before.
  void posesChanged();
  /// See prepareForAnother().
  void anotherComing();
  /// A step of a lesson is on show, or none any more.
  void lessonShown(bool open);

  /// When this returns: the user's own scene is on show.
  void ownSceneWanted();
  /// When this returns: the renderer draws the document's scene, whatever it was compared with.
  void documentSceneWanted();
  /// The renderer draws the document's scene again, or from now on another one to compare it with.
  void documentSceneDrawn(bool drawn);
  /// The same scene is drawn otherwise: reflections off, another view of the surfaces.
  void lookChanged();
  /// An object was picked: its fields show it and its material. Without the latter, the object's own.
  void picked(const QString& node, const QString& material);
  /// The same, and the fields are brought into view.
  void fieldsWanted(const QString& node, const QString& material);

 private:
  void observe();
  void bindActions();

  Document document_;
  ChangeViews changes_{document_};
  Editor editor_{document_};
  ViewState state_;
  Actions* actions_;
  Viewport* viewport_;
  std::unique_ptr<SceneRenderer> renderer_;
  vtkSmartPointer<vtkReflectionProbeRepresentation> shownHandles_;
  std::unique_ptr<SceneSurfaces> surfaces_;
  ProbeWidget* handles_;
  PictureWork* picture_;
  ViewCommands* views_;
  ShownParts* shown_;
  std::function<void()> beforePicture_;
  Models models_;
  ViewState::Names nodes_;
  std::string shownPath_;
  const Lesson* lesson_ = nullptr;
  std::string digestAsRead_;
  std::shared_ptr<const ModelFit> fit_;
};

}  // namespace boxprobe
