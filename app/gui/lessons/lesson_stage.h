// Sets the window up as a lesson's step asks - camera, view of the surfaces, reflections, boxes, rays - and puts back
// what the learner had before the lessons. Called by the lesson view; knows no document.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/gui/explain/debug_view.h"
#include "app/gui/explain/picture_inset.h"
#include "filters/core/scene/lesson.h"
#include "filters/core/scene/surface_view.h"

namespace boxprobe {

class SceneRenderer;
class Viewport;

/// The window's switches that a step sets and that are put back after the lessons.
struct ViewSwitches {
  std::function<bool()> reflections, boxes;  ///< whether they are shown
  std::function<void(bool)> showReflections, showBoxes;
};

class LessonStage {
 public:
  LessonStage(SceneRenderer& renderer, Viewport& viewport, DebugView& debugView, ViewSwitches switches);

  /// Remembers what the learner has.
  void enter();
  void setUp(const LessonStep& step, const Camera& camera);
  /// The step's picture is on the screen: rays can start in it, and the inset's can be followed. True if rays are now
  /// drawn.
  bool pictureDrawn();
  /// The scene, its maps or the camera changed: the inset may show another ray.
  void invalidate() { inset_->invalidate(); }
  /// The window's shape changed: the step's camera is fitted again unless the learner has moved it.
  void shapeChanged();
  void leave();

 private:
  void fitCamera();
  QPointF placeOf(const PicturePoint& point) const;

  struct Settings {
    Camera camera;
    SurfaceViewSettings view;
    bool reflections = true, boxes = true;
    DebugView::Rays rays;
  };

  SceneRenderer& renderer_;
  Viewport& viewport_;
  DebugView& debugView_;
  ViewSwitches switches_;
  std::optional<Settings> own_;
  Camera camera_;                 ///< of the step
  std::optional<Camera> fitted_;  ///< as it was fitted to the window last
  std::vector<PicturePoint> pendingRays_;
  PictureInset* inset_;  ///< the viewport's
  PicturePoint insetAt_{0.5, 0.5};
};

}  // namespace boxprobe
