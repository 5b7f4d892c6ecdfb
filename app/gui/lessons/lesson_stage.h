// Sets the window up as a lesson's step asks - camera, view of the surfaces, reflections, boxes, rays - and puts back
// what the learner had before the lessons.
#pragma once

#include <optional>
#include <vector>

#include "app/gui/explain/debug_view.h"
#include "app/gui/explain/picture_inset.h"
#include "filters/core/scene/lesson.h"
#include "filters/core/scene/surface_view.h"

namespace boxprobe {

class Actions;
class SceneRenderer;
class Viewport;
class Workspace;

class LessonStage {
 public:
  LessonStage(Workspace& workspace, DebugView& debugView);

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
  const Actions& actions_;
  std::optional<Settings> own_;
  Camera camera_;                 ///< of the step
  std::optional<Camera> fitted_;  ///< as it was fitted to the window last
  std::vector<PicturePoint> pendingRays_;
  PictureInset* inset_;  ///< the viewport's
  PicturePoint insetAt_{0.5, 0.5};
};

}  // namespace boxprobe
