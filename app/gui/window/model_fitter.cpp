// See model_fitter.h.
#include "app/gui/window/model_fitter.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <exception>
#include <glm/vector_relational.hpp>
#include <utility>

#include "app/gui/edit/work_beside.h"
#include "app/gui/view/import_bar.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/phrase_words.h"
#include "app/session/automatic_exposure.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

QString kindName(ModelKind kind) {
  switch (kind) {
    case ModelKind::Interior:
      return ModelFitter::tr("Interior");
    case ModelKind::Open:
      return ModelFitter::tr("Open place");
    case ModelKind::Object:
      break;
  }
  return ModelFitter::tr("Object");
}

QString lightName(FitLight light) {
  switch (light) {
    case FitLight::File:
      return ModelFitter::tr("Lights of the file");
    case FitLight::Studio:
      return ModelFitter::tr("Studio");
    case FitLight::Ceiling:
      return ModelFitter::tr("Lamps under the ceiling");
    case FitLight::Openings:
      return ModelFitter::tr("Sky through the openings");
    case FitLight::Daylight:
      break;
  }
  return ModelFitter::tr("Sky and sun");
}

bool inside(const Box& box, const glm::dvec3& point) {
  return glm::all(glm::greaterThan(point, box.min)) && glm::all(glm::lessThan(point, box.max));
}

}  // namespace

ModelFitter::ModelFitter(Workspace& workspace, QMainWindow* window)
    : QObject(window), workspace_(workspace), bar_(new ImportBar(&workspace.viewport())) {
  buildMenu(window);
  connect(bar_, &ImportBar::chosen, this, &ModelFitter::readAs);
  workspace.listenTo(this);
  connect(&workspace, &Workspace::opened, this, &ModelFitter::opened);
  connect(&workspace, &Workspace::lessonShown, this, &ModelFitter::setBorrowed);
  connect(&workspace.scheduler(), &RenderScheduler::rendered, this, &ModelFitter::pictureDrawn);
  connect(workspace.actions().expose, &QAction::triggered, this, &ModelFitter::exposeAgain);
  workspace.changes().add("unit", {&Changes::models}, [this](const Changes&) { modelsChanged(); });
  update();
}

void ModelFitter::buildMenu(QMainWindow* window) {
  menu_ = new QMenu(tr("&Model"), window);
  window->menuBar()->insertMenu(window->menuBar()->actions().last(), menu_);
  const auto addChoice = [](QMenu* menu, QActionGroup* group, const QString& text) {
    QAction* action = menu->addAction(text);
    action->setCheckable(true);
    group->addAction(action);
    return action;
  };
  QMenu* kinds = menu_->addMenu(tr("&Treat as"));
  auto* kindGroup = new QActionGroup(this);
  QMenu* lights = menu_->addMenu(tr("&Light"));
  auto* lightGroup = new QActionGroup(this);
  const auto addKind = [&](std::optional<ModelKind> kind, const QString& text) {
    QAction* action = addChoice(kinds, kindGroup, text);
    kinds_.emplace_back(kind, action);
    connect(action, &QAction::triggered, this, [this, kind] { treatAs(kind); });
  };
  addKind({}, tr("As found"));
  for (const ModelKind kind : {ModelKind::Object, ModelKind::Interior, ModelKind::Open}) addKind(kind, kindName(kind));
  const auto addLight = [&](std::optional<FitLight> light, const QString& text) {
    QAction* action = addChoice(lights, lightGroup, text);
    lights_.emplace_back(light, action);
    connect(action, &QAction::triggered, this, [this, light] { lightBy(light); });
  };
  addLight({}, tr("By the kind of model"));
  for (const FitLight light : allFitLights()) addLight(light, lightName(light));
  connect(menu_->addAction(tr("&Unit and up axis...")), &QAction::triggered, this, &ModelFitter::askAgain);

  button_ = new QToolButton(window->statusBar());
  button_->setObjectName("modelKind");
  button_->setAccessibleName(tr("Kind of model"));
  button_->setMenu(menu_);
  button_->setPopupMode(QToolButton::InstantPopup);
  window->statusBar()->addPermanentWidget(button_);
}

void ModelFitter::opened(const LoadedScene& loaded) {
  wishes_ = FitWishes{};
  fit_ = loaded.fit;
  exposureWaits_ = loaded.exposureAutomatic;
  exposureAsked_ = false;
  refitted_.reset();
  modelsChanged();
  bar_->hide();
  if (fit_ && fit_->guess) {
    bar_->ask(phraseWords(fit_->guess->reason), fit_->guess->unit, fit_->guess->upAxis);
  }
  update();
}

void ModelFitter::modelsChanged() {
  const auto& models = workspace_.document().scene().models;
  if (!fit_ || borrowed_ || models.empty()) return;
  const bool otherwise = models.front().unit != unit_ || models.front().upAxis != up_;
  unit_ = models.front().unit;
  up_ = models.front().upAxis;
  if (otherwise) workspace_.picture().resetCamera();
}

void ModelFitter::askAgain() {
  const auto& models = workspace_.editor().scene().models;
  if (!models.empty()) bar_->ask({}, models.front().unit, models.front().upAxis);
}

void ModelFitter::setBorrowed(bool borrowed) {
  borrowed_ = borrowed;
  // What was asked for in the one scene is not meant for the other.
  if (std::exchange(exposureAsked_, false)) exposureWaits_ = false;
  if (const auto& models = workspace_.document().scene().models; !borrowed && !models.empty()) {
    unit_ = models.front().unit;
    up_ = models.front().upAxis;
  }
  update();
}

void ModelFitter::update() {
  const bool shown = fit_ && !borrowed_;
  workspace_.setFit(shown ? std::make_shared<const ModelFit>(*fit_) : nullptr);
  if (!shown) bar_->hide();
  menu_->setEnabled(shown);
  button_->setVisible(shown);
  if (!shown) return;
  button_->setText(kindName(fit_->kind));
  button_->setAccessibleName(tr("Kind of model: %1").arg(kindName(fit_->kind)));
  button_->setToolTip(phraseWords(fit_->decided));
  for (const auto& [kind, action] : kinds_) action->setChecked(kind == wishes_.kind);
  for (const auto& [light, action] : lights_) action->setChecked(light == wishes_.light);
}

void ModelFitter::treatAs(std::optional<ModelKind> kind) {
  wishes_.kind = kind;
  refit(kind ? tr("Treat as %1").arg(kindName(*kind).toLower()) : tr("Treat as found"));
}

void ModelFitter::lightBy(std::optional<FitLight> light) {
  wishes_.light = light;
  refit(tr("Replace light"));
}

void ModelFitter::readAs(LengthUnit unit, UpAxis up) {
  const auto& models = workspace_.editor().scene().models;
  if (models.empty() || (models.front().unit == unit && models.front().upAxis == up)) return;
  refit(tr("Read in %1, %2").arg(unitName(unit), upAxisName(up)), [unit, up](Scene& scene) {
    scene.models.front().unit = unit;
    scene.models.front().upAxis = up;
  });
}

void ModelFitter::refit(const QString& label, const Document::Edit& first) {
  if (!fit_ || workBesideRuns()) return;
  wishes_.aspect = workspace_.aspect();
  wishes_.studio = studioFile();
  try {
    Scene scene = workspace_.editor().scene();
    if (first) first(scene);
    ModelFit fit;
    const TriangleRays::Models models = workspace_.models();
    workBeside(workspace_.viewport().window(), tr("Fitting the model"), false,
               [&, wishes = wishes_](const BesideProgress&) { fit = fitModel(scene, models, wishes); });
    if (fit.lightKnown) scene.exposure = 1.0;
    scene.groundShadow = scene.ambientOcclusion = fit.kind == ModelKind::Object;
    const std::size_t before = workspace_.document().position();
    workspace_.editor().commit(label, [&](Scene& edited) { edited = scene; });
    exposureWaits_ = !fit.lightKnown;
    exposureAsked_ = false;
    refitted_.reset();
    if (workspace_.document().position() != before)
      refitted_ = Refit{workspace_.document().position(), label.toStdString()};
    fit_ = std::move(fit);
  } catch (const std::exception& error) {
    emit failed(QString::fromStdString(messageOf(error)));
    return;
  }
  update();
  emit message(phraseWords(fit_->decided));
  workspace_.picture().resetCamera();
}

void ModelFitter::exposeAgain() {
  exposureWaits_ = exposureAsked_ = true;
  workspace_.requestPicture();
}

void ModelFitter::pictureDrawn() {
  if (!exposureWaits_ || (borrowed_ && !exposureAsked_) || workspace_.renderer().workPending()) return;
  exposureWaits_ = false;
  QTimer::singleShot(0, this, &ModelFitter::expose);  // not within the frame that was drawn
}

// The step is made once more beside the document, whose views are then told of the exposure alone.
void ModelFitter::exposeStep(double exposure) {
  Scene scene = workspace_.document().scene();
  scene.exposure = exposure;
  Document beside;
  beside.restore(workspace_.document().state());
  const std::string label = beside.undoLabel();
  beside.undo();
  beside.commit(label, [&scene](Scene& edited) { edited = scene; });
  workspace_.document().restore(beside.state());
  emit workspace_.editor().settled();
}

void ModelFitter::expose() {
  const bool asked = std::exchange(exposureAsked_, false);
  if ((borrowed_ && !asked) || workspace_.document().scene().models.empty()) return;
  const bool within = fit_ && !borrowed_
                          ? fit_->within
                          : inside(workspace_.renderer().bounds(), workspace_.renderer().currentCamera().position);
  const double exposure =
      measuredExposure(workspace_.renderer(), within, workspace_.aspect(), workspace_.editor().scene().tone);
  const bool asOpened = !asked && !workspace_.document().canUndo() && !workspace_.document().canRedo() &&
                        !workspace_.document().previewing();
  if (asOpened) {
    // Part of opening it: nothing to undo or to save.
    Scene scene = workspace_.document().scene();
    scene.exposure = exposure;
    const std::optional<std::size_t> selected = workspace_.document().selectedProbe();
    const std::optional<std::string> name = selected ? std::optional(scene.probes[*selected].name) : std::nullopt;
    workspace_.document().restore(Document::State::opened(std::move(scene), workspace_.document().path(), name));
  } else if (!asked && workspace_.document().canRedo()) {
    return;  // what it was for was undone
  } else if (!asked && refitted_ && refitted_->position == workspace_.document().position() &&
             refitted_->label == workspace_.document().undoLabel() && !workspace_.document().previewing()) {
    exposeStep(exposure);
  } else {
    workspace_.editor().commit(tr("Automatic exposure"), [exposure](Scene& scene) { scene.exposure = exposure; });
  }
  const QString decided = asked || !fit_ ? tr("As the picture asks") : phraseWords(fit_->decided);
  emit message(tr("%1; exposure %2").arg(decided).arg(exposure));
}

}  // namespace boxprobe
