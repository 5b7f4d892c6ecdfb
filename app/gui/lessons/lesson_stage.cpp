// See lesson_stage.h.
#include "app/gui/lessons/lesson_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

#include "app/gui/explain/surface_view_panel.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

/// Lessons are made for pictures of this width by height, as sheets have them.
constexpr double kLessonAspect = 16.0 / 10.0;

/// Wide enough for all of the lesson's picture, which a window that is narrower would cut at both sides.
Camera fittedTo(Camera camera, double aspect) {
  const double grow = std::max(kLessonAspect / aspect, 1.0);
  const double half = 0.5 * glm::radians(camera.verticalFovDegrees);
  constexpr double kWidestDegrees = 150.0;
  camera.verticalFovDegrees = std::min(glm::degrees(2.0 * std::atan(grow * std::tan(half))), kWidestDegrees);
  camera.parallelHeight *= grow;
  return camera;
}

double aspectOf(const Viewport& viewport) {
  return static_cast<double>(std::max(viewport.width(), 1)) / std::max(viewport.height(), 1);
}

/// Names apart; where it stands goes through VTK and back without a change.
bool sameView(const Camera& a, const Camera& b) {
  return a.position == b.position && a.target == b.target && a.verticalFovDegrees == b.verticalFovDegrees &&
         a.parallelHeight == b.parallelHeight;
}

}  // namespace

LessonStage::LessonStage(Workspace& workspace, DebugView& debugView)
    : renderer_(workspace.renderer()),
      viewport_(workspace.viewport()),
      debugView_(debugView),
      actions_(workspace.actions()),
      inset_(new PictureInset(&viewport_, [this](const QPointF& place) { return debugView_.explain(place); })) {}

void LessonStage::enter() {
  own_ = Settings{renderer_.currentCamera(), debugView_.surfacePanel()->settings(), actions_.reflections->isChecked(),
                  actions_.boxes->isChecked(), debugView_.drawnRays()};
}

void LessonStage::setUp(const LessonStep& step, const Camera& camera) {
  debugView_.unpin();
  actions_.reflections->setChecked(step.reflections);
  actions_.boxes->setChecked(step.boxes);
  debugView_.surfacePanel()->choose(findSurfaceView(step.view).value_or(0));
  DebugView::Rays rays = own_ ? own_->rays : DebugView::Rays();
  rays.clicks.clear();
  rays.settings.maximumLength = debugView_.drawnRays().settings.maximumLength;  // it goes with the scene
  debugView_.drawRays(rays);
  camera_ = camera;
  fitCamera();
  pendingRays_ = step.rays;
  inset_->show(step.inset);
  if (step.inset) insetAt_ = step.inset->at;
}

void LessonStage::fitCamera() {
  renderer_.applyCamera(fittedTo(camera_, aspectOf(viewport_)));
  fitted_ = renderer_.currentCamera();
  debugView_.cameraMoved();
}

void LessonStage::shapeChanged() {
  if (fitted_ && sameView(*fitted_, renderer_.currentCamera())) fitCamera();
}

// A share of the lesson's picture, which is in the middle of the window's and as large as that has room for.
QPointF LessonStage::placeOf(const PicturePoint& point) const {
  const double width = std::min<double>(viewport_.width(), viewport_.height() * kLessonAspect);
  const double height = width / kLessonAspect;
  return {0.5 * viewport_.width() + (point[0] - 0.5) * width, 0.5 * viewport_.height() + (point[1] - 0.5) * height};
}

bool LessonStage::pictureDrawn() {
  inset_->update(placeOf(insetAt_));
  if (pendingRays_.empty()) return false;
  std::vector<QPointF> positions;
  for (const PicturePoint& point : pendingRays_) positions.push_back(placeOf(point));
  pendingRays_.clear();
  debugView_.drawRaysAt(positions);
  return true;
}

void LessonStage::leave() {
  pendingRays_.clear();
  inset_->show({});
  fitted_.reset();
  if (!own_) return;
  debugView_.unpin();
  actions_.reflections->setChecked(own_->reflections);
  actions_.boxes->setChecked(own_->boxes);
  debugView_.surfacePanel()->show(own_->view);
  debugView_.drawRays(own_->rays);
  renderer_.applyCamera(own_->camera);
  debugView_.cameraMoved();
  own_.reset();
}

}  // namespace boxprobe
