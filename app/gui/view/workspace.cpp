// See workspace.h.
#include "app/gui/view/workspace.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenuBar>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/handles/scene_surfaces.h"
#include "app/gui/view/motion_preview.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/rest_refinement.h"
#include "app/gui/view/shown_parts.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/view/viewport.h"
#include "app/session/opened_glb.h"
#include "filters/core/geometry/probe_at.h"
#include "filters/core/scene/lesson.h"
#include "filters/fit/rays/triangle_sight.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

Workspace::Workspace(QMainWindow* window)
    : actions_(new Actions(window->menuBar())),
      viewport_(new Viewport(window)),
      renderer_(std::make_unique<SceneRenderer>(viewport_->window3d())),
      shownHandles_(vtkSmartPointer<vtkReflectionProbeRepresentation>::New()),
      surfaces_(std::make_unique<SceneSurfaces>(document_)),
      handles_(new ProbeWidget(
          editor_, state_, *shownHandles_, *surfaces_, [this] { return viewport_->view(); }, this)),
      picture_(new PictureWork(
          document_, *renderer_, *viewport_,
          [this] {
            if (beforePicture_) beforePicture_();
            shownHandles_->Follow(viewport_->view());
          },
          this)),
      views_(new ViewCommands(editor_, state_, *renderer_, *viewport_, *surfaces_, this)),
      shown_(new ShownParts({editor_, state_, *renderer_, *surfaces_, models_, nodes_}, this)) {
  renderer_->setSightLines(traceSightLines);  // the shadows of lamps drawn as shapes, by what fits boxes
  renderer_->setEditable(true);
  renderer_->showCoarseFirst(true);
  viewport_->setCamera([this] { return renderer_->renderer()->GetActiveCamera(); },
                       [this](const Ray& ray) { return surfaces_->meet(ray); }, [this] { return renderer_->bounds(); });
  viewport_->setProbeWidget(handles_);
  shownHandles_->SetRenderer(renderer_->renderer());

  // A lesson shows its techniques as they are.
  picture_->setPlainWhere([this] { return lesson_ != nullptr; });
  observe();
  bindActions();
}

void Workspace::observe() {
  // The renderer comes first, for views ask it.
  changes_.add("picture", ChangeKinds::all(), [this](const Changes& changes) { picture_->syncScene(changes); });
  changes_.add("surfaces", {&Changes::models, &Changes::objects},
               [this](const Changes& changes) { surfaces_->documentChanged(changes); });
  // A drag has nothing left to move once anything else was edited.
  changes_.add("handles", ChangeKinds::all(), [this](const Changes&) { handles_->update(); });
  connect(&editor_, &Editor::settled, picture_, &PictureWork::editSettled);
  connect(&editor_, &Editor::selectionChanged, handles_, &ProbeWidget::update);
  connect(handles_, &ProbeWidget::pictureChanged, this, &Workspace::requestPicture);
  connect(shown_, &ShownParts::pictureChanged, this, &Workspace::requestPicture);
  connect(views_, &ViewCommands::cameraMoved, viewport_, &Viewport::cameraMoved);
  connect(&editor_, &Editor::failed, this, &Workspace::failed);
  connect(picture_, &PictureWork::failed, this, &Workspace::failed);
  connect(handles_, &ProbeWidget::hint, this, &Workspace::message);
  connect(shown_, &ShownParts::message, this, &Workspace::message);
  connect(views_, &ViewCommands::message, this, &Workspace::message);
}

void Workspace::bindActions() {
  const Actions& a = *actions_;
  connect(a.handleModes, &QActionGroup::triggered, this,
          [this](const QAction* mode) { handles_->setMode(static_cast<HandleMode>(mode->data().toInt())); });
  connect(handles_, &ProbeWidget::modeChanged, this,
          [this](HandleMode mode) { showChoice(actions_->handleModes, static_cast<int>(mode)); });
  connect(a.boxes, &QAction::toggled, handles_, &ProbeWidget::setVisible);

  connect(a.resetView, &QAction::triggered, picture_, &PictureWork::resetCamera);
  connect(a.reflections, &QAction::toggled, picture_, &PictureWork::setReflectionsShown);
  connect(a.reflections, &QAction::toggled, this, &Workspace::lookChanged);
  MotionPreview* motion = &picture_->motion();
  connect(a.motionPreview, &QAction::toggled, motion, &MotionPreview::setEnabled);
  connect(motion, &MotionPreview::enabledChanged, a.motionPreview, &QAction::setChecked);
  RestRefinement* refinement = &picture_->refinement();
  a.refinement->setChecked(refinement->enabled());
  connect(a.refinement, &QAction::toggled, refinement, &RestRefinement::setEnabled);
  connect(refinement, &RestRefinement::enabledChanged, a.refinement, &QAction::setChecked);

  connect(a.frame, &QAction::triggered, views_, &ViewCommands::frameSelection);
  connect(a.lookFrom, &QAction::triggered, views_, &ViewCommands::lookFromProbe);
  connect(a.axes, &QActionGroup::triggered, views_, [this](const QAction* axis) {
    views_->lookAlong(kBoxFaces[static_cast<std::size_t>(axis->data().toInt())]);
  });
  connect(a.walk, &QAction::toggled, views_, &ViewCommands::setWalking);

  connect(a.hide, &QAction::triggered, shown_, &ShownParts::hideSelected);
  connect(a.showAll, &QAction::triggered, &state_, &ViewState::showAll);
  connect(a.isolate, &QAction::triggered, shown_, &ShownParts::toggleIsolation);
  a.cutaway->setChecked(state_.cutaway());
  connect(a.cutaway, &QAction::toggled, shown_, &ShownParts::setCutaway);
  connect(a.cutaway, &QAction::toggled, views_, &ViewCommands::forgetHint);
}

Workspace::~Workspace() {
  // The handles and the scene hold GL objects of the viewport's context: they go first, while it is there.
  viewport_->window3d()->MakeCurrent();
  renderer_->releaseGraphics();
  shownHandles_->SetRenderer(nullptr);
  renderer_.reset();
  delete viewport_;
}

void Workspace::begin() {
  // After all views, for some show whether work was stopped until now.
  changes_.add("work", ChangeKinds::all(), [this](const Changes&) { scheduler().sceneChanged(); });
  changes_.add("shown parts",
               {&Changes::probeShape, &Changes::probeList, &Changes::selection, &Changes::objects, &Changes::models},
               [this](const Changes& changes) { shown_->documentChanged(changes); });
  changes_.updateAll();
}

vtkReflectionProbeRepresentation& Workspace::shownHandles() const {
  return *shownHandles_;
}

RenderScheduler& Workspace::scheduler() const {
  return picture_->scheduler();
}

double Workspace::aspect() const {
  return viewport_->height() > 0 ? static_cast<double>(viewport_->width()) / viewport_->height() : 1.0;
}

bool Workspace::atRest() const {
  return scheduler().idle() && !renderer_->workPending();
}

void Workspace::requestPicture() {
  scheduler().requestRender();
}

void Workspace::showScene(const LoadedScene& loaded) {
  emit opening();
  showModels(loaded.models, ownPathOf(loaded.path, loaded.scene));
  document_.open(loaded.scene, loaded.path, loaded.unsaved);
  emit opened(loaded);
  picture_->resetCamera();
  document_.selectProbe(probeNearest(document_.scene().probes, renderer_->currentCamera().position));
}

void Workspace::showModels(const Models& models, const std::string& path) {
  handles_->cancel();
  // Names of another scene mean others; those of one that is read again are the same.
  if (path != shownPath_) state_.forget();
  shownPath_ = path;
  nodes_.clear();
  for (const auto& model : models) {
    for (const Instance& instance : model->instances) {
      if (!instance.node.empty()) nodes_.insert(instance.node);
    }
  }
  takePose(models);
  emit modelsReplaced();
}

void Workspace::takePose(const Models& models) {
  models_ = models;
  surfaces_->setModels(models);
  renderer_->setModels(models);
  editor_.selectAlone();
  views_->forgetView();
  emit posesChanged();
}

void Workspace::prepareForAnother() {
  handles_->cancel();
  emit anotherComing();
}

QString Workspace::displayName() const {
  if (lesson_ != nullptr) return tr("Lesson: %1").arg(QString::fromStdString(lesson_->title));
  if (!document_.path().empty()) return QFileInfo(QString::fromStdString(document_.path())).fileName();
  const auto& models = document_.scene().models;
  if (models.empty()) return tr("no scene");
  return tr("%1 (not saved)").arg(QFileInfo(QString::fromStdString(models.front().file)).fileName());
}

QString Workspace::folder() const {
  if (!document_.path().empty()) return QFileInfo(QString::fromStdString(document_.path())).absolutePath();
  const auto& models = document_.scene().models;
  return models.empty() ? QString() : QFileInfo(QString::fromStdString(models.front().file)).absolutePath();
}

QString Workspace::folderShown() const {
  return lesson_ == nullptr ? QDir::toNativeSeparators(folder()) : QString();
}

}  // namespace boxprobe
