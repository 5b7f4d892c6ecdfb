// Moves a camera by the mouse: orbit about the point under the pointer, look around, pan, zoom; and flies it by keys,
// at eye height if wanted. Called by the viewport for events no handle took; knows neither scene nor probes, and of
// surfaces only where a ray meets one.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QTimer>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <set>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/view_projection.h"

class vtkCamera;

namespace boxprobe {

class CameraController : public QObject {
  Q_OBJECT

 public:
  enum class Motion { None, Orbit, Pan, Zoom, Look, TurnSky };
  struct Hooks {
    std::function<vtkCamera*()> camera;
    std::function<Ray(const QPointF& pixel)> ray;
    std::function<std::optional<glm::dvec3>(const Ray&)> meet;  ///< the surface there, world
    std::function<Box()> bounds;                                ///< of the scene: speeds follow its size
  };

  explicit CameraController(QObject* parent = nullptr);
  void setHooks(Hooks hooks) { hooks_ = std::move(hooks); }

  void begin(Motion motion, const QPointF& pixel);
  /// True if the camera moved. `viewportHeight` in the pixels of `pixel`.
  bool move(const QPointF& pixel, double viewportHeight);
  void end();
  Motion motion() const { return motion_; }

  /// `steps` of a mouse wheel at `pixel`, positive comes closer. While looking around it makes flying faster or slower.
  void wheel(const QPointF& pixel, double steps);

  /// True for the keys that fly: W, A, S, D, and E, Q (up, down) while the right button looks around.
  bool takesKey(int key, Qt::KeyboardModifiers modifiers) const;
  void keyDown(int key, bool fast);
  void keyUp(int key);
  void stopFlying();
  bool flying() const { return !keys_.empty(); }

  /// Flying keeps the eyes 1.6 m above what stands below.
  void setWalking(bool on);
  bool walking() const { return walking_; }
  static constexpr double kEyeHeight = 1.6;  ///< metres

  /// The view is now one along an axis, in parallel projection: turning it goes back to this angle of view.
  void setAxisView(double verticalFovDegrees) { axisViewFov_ = verticalFovDegrees; }

 signals:
  void moved();  ///< by keys
  /// By a drag that began with Motion::TurnSky: what turns the sky about +Y so that it follows the pointer, degrees
  /// since then.
  void skyTurned(double degrees);
  void skyTurnEnded();

 private:
  void fly();
  void leaveAxisView();
  void standOnFloor(bool any);  ///< however high the step up to it
  double diagonal() const;

  Hooks hooks_;
  Motion motion_ = Motion::None;
  QPointF last_;
  glm::dvec3 pivot_{0.0};
  double skyDegrees_ = 0.0;
  std::set<int> keys_;
  bool fast_ = false, walking_ = false;
  double speed_ = 1.0;  ///< times what the scene's size gives
  std::optional<double> axisViewFov_;
  QTimer timer_;
  QElapsedTimer clock_;
};

}  // namespace boxprobe
