// Moves a camera by the mouse: orbit around the point looked at, pan, and zoom towards it, with the world's vertical
// kept upright. Called by the viewport for mouse events no handle took; knows neither scene nor probes.
#pragma once

#include <QPointF>

class vtkCamera;

namespace boxprobe {

class CameraController {
 public:
  enum class Motion { None, Orbit, Pan, Zoom };

  void begin(Motion motion, const QPointF& pixel);
  /// True if the camera moved. `viewportHeight` in the pixels of `pixel`.
  bool move(vtkCamera* camera, const QPointF& pixel, double viewportHeight);
  void end() { motion_ = Motion::None; }
  Motion motion() const { return motion_; }

  /// `steps` of a mouse wheel, positive brings the focal point closer.
  static void zoom(vtkCamera* camera, double steps);

 private:
  Motion motion_ = Motion::None;
  QPointF last_;
};

}  // namespace boxprobe
