// See debug_view.h.
#include "app/gui/explain/debug_view.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QCheckBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/geometric.hpp>

#include "app/gui/explain/diffuse_truth.h"
#include "app/gui/explain/explain_card.h"
#include "app/gui/explain/mirror_lines.h"
#include "app/gui/explain/ray_panel.h"
#include "app/gui/explain/schematic_inset.h"
#include "app/gui/explain/surface_view_panel.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/phrase_words.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

DebugView::DebugView(Workspace& workspace)
    : renderer_(workspace.renderer()),
      viewport_(workspace.viewport()),
      document_(workspace.document()),
      inspector_({[this] { return !paused_ && viewport_.readyToDraw() && !document_.scene().models.empty(); },
                  [this](const QPointF& position) { return hold(position); },
                  [this](const QPointF& position) { return explain(position); }}),
      rays_(std::make_unique<RayRig>(renderer_.renderer(),
                                     [this] {
                                       const int* size = viewport_.window3d()->GetSize();
                                       return PixelRays(seenFrom(), size[0], size[1]);
                                     })),
      mirrors_(std::make_unique<MirrorLines>(renderer_.renderer())),
      truth_(new DiffuseTruth(renderer_, this)),
      panel_(new QWidget),
      tool_(new QPushButton(tr("Explain pixels"), panel_)),
      schematicShown_(new QCheckBox(tr("Plan and elevation in the picture"), panel_)),
      mirrorsShown_(new QCheckBox(tr("View of planar mirrors"), panel_)),
      surfacePanel_(new SurfaceViewPanel(panel_)),
      rayPanel_(new RayPanel(panel_)),
      card_(new ExplainCard([this](const std::string& probe) { return renderer_.explainedMaps(probe); })),
      explainPanel_(new QWidget),
      schematic_(new SchematicInset(SchematicInset::InLayout())),
      inset_(new SchematicInset(&viewport_)) {
  buildPanel();
  auto* column = new QVBoxLayout(explainPanel_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(card_, 1);
  column->addWidget(schematic_);
  connectParts();
  rays_->setSettings(rayPanel_->settings());
  showNothing();
  observe(workspace);
}

DebugView::~DebugView() = default;

void DebugView::observe(Workspace& workspace) {
  workspace.listenTo(this);
  workspace.setBeforePicture([this] { update(); });
  workspace.changes().add("debug view", ChangeKinds::all(),
                          [this](const Changes& changes) { documentChanged(changes); });
  connect(&workspace, &Workspace::posesChanged, this, [this, &workspace] { setModels(workspace.models()); });
  connect(this, &DebugView::pictureChanged, &workspace, &Workspace::requestPicture);
  connect(&workspace.viewport(), &Viewport::cameraMoved, this, &DebugView::cameraMoved);
  connect(&workspace.picture(), &PictureWork::cameraPlaced, this, &DebugView::cameraMoved);
  connect(&workspace.scheduler(), &RenderScheduler::workEnded, this, &DebugView::workEnded);
  connect(card_, &ExplainCard::mendRequested, this, [&workspace](const Mend& mend) {
    workspace.editor().commit(phraseWords(mend.words), [mend](Scene& scene) {
      if (const auto index = findProbe(scene, mend.probe)) scene.probes[*index] = mend.after;
    });
  });

  const Actions& actions = workspace.actions();
  connect(actions.explain, &QAction::toggled, this, &DebugView::setTool);
  connect(this, &DebugView::toolChanged, actions.explain, &QAction::setChecked);
  // Pixels are explained of the document's scene.
  connect(&workspace, &Workspace::documentSceneDrawn, this, [this](bool drawn) { setPaused(!drawn); });
  connect(this, &DebugView::toolChanged, &workspace, [&workspace](bool on) {
    if (on) emit workspace.documentSceneWanted();
  });
  connect(actions.copyText, &QAction::triggered, this, &DebugView::copyText);
  connect(actions.copyJson, &QAction::triggered, this, &DebugView::copyJson);
  connect(actions.saveRays, &QAction::triggered, this, &DebugView::saveRays);
  connect(surfacePanel_, &SurfaceViewPanel::changed, &workspace, &Workspace::lookChanged);
  const QActionGroup* views = actions.surfaceViews;
  connect(views, &QActionGroup::triggered, surfacePanel_,
          [this](const QAction* view) { surfacePanel_->choose(view->data().toInt()); });
  connect(surfacePanel_, &SurfaceViewPanel::changed, views,
          [views](const SurfaceViewSettings& settings) { showChoice(views, settings.view); });
}

void DebugView::releaseGraphics() {
  rays_.reset();
  mirrors_.reset();
}

void DebugView::buildPanel() {
  auto* layout = new QVBoxLayout(panel_);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(6);
  QFormLayout* form = addSection(panel_, tr("Explain"));
  tool_->setCheckable(true);
  tool_->setObjectName("explainTool");
  tool_->setToolTip(tr("Explains how the pixel under the pointer gets its colour; a click pins it (E)"));
  form->addRow(tool_);
  schematicShown_->setToolTip(tr("The same drawing stands under the explanation"));
  inset_->setShown(false);
  schematicShown_->setObjectName("schematicShown");
  form->addRow(schematicShown_);
  mirrorsShown_->setObjectName("mirrorsShown");
  mirrorsShown_->setToolTip(
      tr("Shows each mirror's mirrored camera and its view through the mirror; for an explained pixel, the reflected "
         "ray up to the moving object"));
  form->addRow(mirrorsShown_);
  layout->addWidget(surfacePanel_);
  layout->addWidget(rayPanel_);
  layout->addStretch(1);
}

void DebugView::connectParts() {
  connect(&viewport_, &Viewport::pointerMoved, &inspector_, &PixelInspector::pointerMoved);
  connect(&viewport_, &Viewport::pointerLeft, &inspector_, &PixelInspector::pointerLeft);
  connect(&viewport_, &Viewport::clicked, &inspector_, &PixelInspector::click);
  connect(truth_, &DiffuseTruth::failed, this, &DebugView::failed);
  connect(truth_, &DiffuseTruth::pictureChanged, this, [this] {
    inspector_.invalidate();
    emit pictureChanged();
  });
  connect(&inspector_, &PixelInspector::explained, this, &DebugView::show);
  connect(&inspector_, &PixelInspector::nothingExplained, this, &DebugView::showNothing);
  connect(&inspector_, &PixelInspector::readout, this, &DebugView::showReadout);
  connect(&inspector_, &PixelInspector::readoutEnded, this, [this] { viewport_.showReadout({}, {}); });
  connect(&inspector_, &PixelInspector::pinChanged, this, [this](bool pinned) {
    if (!pinned) pinnedCamera_ = nullptr;
    card_->setPinned(pinned);
    cameraMoved();
  });
  connect(&inspector_, &PixelInspector::clicked, this, [this](const Explanation& e) {
    rays_->addClick(e);
    raysChanged();
  });
  connect(card_, &ExplainCard::unpinRequested, &inspector_, &PixelInspector::unpin);
  connect(tool_, &QPushButton::clicked, this, &DebugView::setTool);
  connect(schematicShown_, &QCheckBox::toggled, this, [this](bool shown) {
    inset_->setShown(shown);
    inspector_.invalidate();
  });
  connect(surfacePanel_, &SurfaceViewPanel::changed, this, &DebugView::setSurfaceView);
  connect(mirrorsShown_, &QCheckBox::toggled, this, [this](bool shown) {
    mirrors_->setShown(shown);
    emit pictureChanged();
  });
  connect(rayPanel_, &RayPanel::changed, this, [this](const RaySettings& settings) {
    rays_->setSettings(settings);
    raysChanged();
  });
  connect(rayPanel_, &RayPanel::clearRequested, this, [this] {
    rays_->setClicks({});
    raysChanged();
  });
  connect(rayPanel_, &RayPanel::saveRequested, this, &DebugView::saveRays);
}

double DebugView::pixelScale() const {
  return viewport_.devicePixelRatioF();
}

Explanation DebugView::explain(const QPointF& position) const {
  viewport_.window3d()->MakeCurrent();
  const int* size = viewport_.window3d()->GetSize();
  const auto device = [this](double logical, int limit) {
    return std::clamp(static_cast<int>(std::floor(logical * pixelScale())), 0, limit - 1);
  };
  try {
    return renderer_.explain(device(position.x(), size[0]), device(position.y(), size[1]), size[0], size[1]);
  } catch (const Error& error) {
    Explanation unknown;
    unknown.notes.push_back(Phrase::plain(error.what()));
    return unknown;
  }
}

vtkCamera* DebugView::seenFrom() const {
  return pinnedCamera_ ? pinnedCamera_.Get() : renderer_.renderer()->GetActiveCamera();
}

PixelInspector::Explain DebugView::hold(const QPointF& position) {
  const auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->DeepCopy(renderer_.renderer()->GetActiveCamera());
  pinnedCamera_ = camera;
  return [this, position, camera] {
    vtkRenderer* scene = renderer_.renderer();
    const vtkSmartPointer<vtkCamera> current = scene->GetActiveCamera();
    scene->SetActiveCamera(camera);
    Explanation explanation = explain(position);
    scene->SetActiveCamera(current);
    current->Modified();  // shared programs hold the other camera's uniforms now
    return explanation;
  };
}

void DebugView::setModels(const std::vector<std::shared_ptr<const Model>>& models) {
  inspector_.unpin();
  rays_->setModels(models);
  truth_->setModels(models);
  mirrors_->setModels(models);
}

void DebugView::documentChanged(const Changes& changes) {
  const bool geometry = changes.models || changes.objects || changes.materials;
  if (geometry || changes.probeList || changes.probeShape || changes.probeTechnique || changes.probeCapture) {
    rays_->setScene(document_.scene(), geometry);
  }
  if (changes.models) {
    rayPanel_->setObjects(rays_->objects());
    const double diagonal = glm::length(renderer_.bounds().size());
    rayPanel_->setMaximumLength(std::max(diagonal, 1e-3));
  }
  truth_->sceneChanged();
  surfacePanel_->showRange(renderer_.viewRange());
  inspector_.invalidate();
}

void DebugView::cameraMoved() {
  inspector_.cameraMoved();
  if (rays_->followsCamera() && !pinnedCamera_) rays_->setSettings(rayPanel_->settings());
}

void DebugView::workEnded() {
  inspector_.invalidate();
}

void DebugView::update() {
  inspector_.update();
  const int* size = viewport_.window3d()->GetSize();
  if (!paused_) truth_->update(document_.scene(), QSize(size[0], size[1]));
  rays_->setPixelScale(pixelScale());
  rays_->update();
  updateMirrors();
}

// Those of the picture before: which have one follows from the camera, and the next picture is not drawn yet.
void DebugView::updateMirrors() {
  if (!mirrors_->shown()) return;
  std::vector<std::string> drawn;
  for (const FrameReport::MirrorUse& mirror : renderer_.frameReport().mirrors) {
    if (mirror.drawn) drawn.push_back(mirror.node);
  }
  vtkCamera* camera = seenFrom();
  glm::dvec3 eye, forward;
  camera->GetPosition(&eye.x);
  camera->GetDirectionOfProjection(&forward.x);
  mirrors_->update(document_.scene(), drawn, eye, forward, camera->GetParallelProjection() != 0);
}

void DebugView::setTool(bool on) {
  tool_->setChecked(on);
  viewport_.setPicking(on);
  inspector_.setTool(on);
  if (!on) showNothing();
  emit toolChanged(on);
}

void DebugView::setPaused(bool paused) {
  paused_ = paused;
  if (!paused) inspector_.invalidate();
}

bool DebugView::unpin() {
  if (!inspector_.pinned()) return false;
  inspector_.unpin();
  return true;
}

void DebugView::show(const Explanation& explanation) {
  card_->show(explanation, verdictOf(explanation, document_.scene()), document_.scene().exposure,
              document_.scene().tone);
  for (SchematicInset* plan : {schematic_, inset_}) {
    plan->show(explanation, QPointF(explanation.x, explanation.y) / pixelScale());
  }
  mirrors_->explain(&explanation);
  if (rays_->explain(&explanation) || mirrors_->shown()) raysChanged();
}

void DebugView::showNothing() {
  card_->showHint(inspector_.tool() ? tr("Move the pointer over the picture. A click pins what it explains.")
                                    : tr("Switch the Explain tool on (E), then move the pointer over the picture."));
  for (SchematicInset* plan : {schematic_, inset_}) plan->clear();
  mirrors_->explain(nullptr);
  if (rays_->explain(nullptr) || mirrors_->shown()) raysChanged();
}

void DebugView::showReadout(const Explanation& explanation, const QPointF& position) {
  const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(renderer_.view().view)];
  viewport_.showReadout(surfaceViewReadout(row, explanation), position);
}

void DebugView::setSurfaceView(const SurfaceViewSettings& settings) {
  renderer_.setView(settings);
  truth_->setWanted(surfaceViews()[static_cast<std::size_t>(settings.view)].id == "diffuse-error");
  surfacePanel_->showRange(renderer_.viewRange());
  inspector_.setReadout(settings.view != 0);
  emit pictureChanged();
}

void DebugView::raysChanged() {
  const bool drawn = rays_->update() || mirrors_->shown();
  rayPanel_->showStatus(rays_->status());
  if (drawn) emit pictureChanged();
}

void DebugView::drawRays(const Rays& rays) {
  rays_->setClicks(rays.clicks);
  rayPanel_->show(rays.settings);
}

void DebugView::drawRaysAt(const std::vector<QPointF>& positions) {
  RaySettings settings = rayPanel_->settings();
  settings.shown = true;
  settings.source = RaySource::Clicked;
  settings.count = std::max(settings.count, static_cast<int>(positions.size()));
  rays_->setClicks({});
  for (const QPointF& position : positions) rays_->addClick(explain(position));
  rayPanel_->show(settings);
}

void DebugView::saveRays() {
  const QString path =
      QFileDialog::getSaveFileName(&viewport_, tr("Save rays"), "rays.vtp", tr("VTK poly data (*.vtp)"));
  if (path.isEmpty()) return;
  try {
    rays_->save(path.toStdString());
    emit message(tr("Saved %1 lines to %2").arg(rays_->rays()).arg(path));
  } catch (const std::exception& error) {
    emit failed(QString::fromStdString(messageOf(error)));
  }
}

void DebugView::copyText() {
  if (card_->empty()) {
    emit failed(tr("No pixel is explained yet. Press E and point at a surface"));
    return;
  }
  card_->copyText();
  emit message(tr("Copied the explanation as text"));
}

void DebugView::copyJson() {
  if (card_->empty()) {
    emit failed(tr("No pixel is explained yet. Press E and point at a surface"));
    return;
  }
  card_->copyJson();
  emit message(tr("Copied the explanation as JSON"));
}

}  // namespace boxprobe
