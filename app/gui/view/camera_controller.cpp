// See camera_controller.h.
#include "app/gui/view/camera_controller.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/gui/view/camera_moves.h"

namespace boxprobe {

namespace {

constexpr double kDegreesPerPixel = 0.35, kLookDegreesPerPixel = 0.2;
constexpr double kZoomPerStep = 1.12;
constexpr double kZoomPerPixel = 1.008;
constexpr double kSmallestStep = 0.004;            ///< of the scene's diagonal, by a notch of the wheel
constexpr double kFlightShare = 0.16;              ///< of the diagonal in a second
constexpr double kSlowest = 0.5, kFastest = 20.0;  ///< scene units per second, before the wheel's say
constexpr double kFastTimes = 4.0;
constexpr double kHighestStep = 0.5;  ///< walked up: stairs, not tables
constexpr int kTickMilliseconds = 16;

}  // namespace

CameraController::CameraController(QObject* parent) : QObject(parent) {
  timer_.setInterval(kTickMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &CameraController::fly);
}

double CameraController::diagonal() const {
  return std::max(glm::length(hooks_.bounds().size()), 1e-3);
}

void CameraController::leaveAxisView() {
  vtkCamera* camera = hooks_.camera();
  if (!axisViewFov_ || camera->GetParallelProjection() == 0) return;
  // As far away as makes the focal plane as large as it was.
  const double half = std::tan(glm::radians(0.5 * *axisViewFov_));
  const double distance = camera->GetParallelScale() / half;
  double target[3];
  camera->GetFocalPoint(target);
  const glm::dvec3 at(target[0], target[1], target[2]);
  const glm::dvec3 eye = at - forwardOf(camera) * distance;
  camera->SetParallelProjection(0);
  camera->SetViewAngle(*axisViewFov_);
  camera->SetPosition(eye.x, eye.y, eye.z);
  axisViewFov_.reset();
  if (std::abs(forwardOf(camera).y) < 0.99) {
    camera->SetViewUp(0.0, 1.0, 0.0);
    return;
  }
  // Straight from above: tilted a little, so that the world's vertical is one on the screen.
  const double* up = camera->GetViewUp();
  const glm::dvec3 ahead(up[0], up[1], up[2]);
  const glm::dvec3 tilted = at - glm::normalize(forwardOf(camera) + 0.05 * ahead) * distance;
  camera->SetPosition(tilted.x, tilted.y, tilted.z);
  camera->SetViewUp(0.0, 1.0, 0.0);
}

void CameraController::begin(Motion motion, const QPointF& pixel) {
  motion_ = motion;
  last_ = pixel;
  skyDegrees_ = 0.0;
  vtkCamera* camera = hooks_.camera();
  if (motion == Motion::Look) pivot_ = eyeOf(camera);
  if (motion != Motion::Orbit) return;
  double target[3];
  camera->GetFocalPoint(target);
  pivot_ = hooks_.meet(hooks_.ray(pixel)).value_or(glm::dvec3(target[0], target[1], target[2]));
}

void CameraController::end() {
  if (motion_ == Motion::TurnSky) emit skyTurnEnded();
  motion_ = Motion::None;
  // E and Q fly only while the button is held.
  keyUp(Qt::Key_E);
  keyUp(Qt::Key_Q);
}

bool CameraController::move(const QPointF& pixel, double viewportHeight) {
  const QPointF delta = pixel - last_;
  last_ = pixel;
  if (motion_ == Motion::None || delta.isNull()) return false;
  vtkCamera* camera = hooks_.camera();
  if (motion_ == Motion::TurnSky) {
    skyDegrees_ -= delta.x() * camera->GetViewAngle() / std::max(viewportHeight, 1.0);
    emit skyTurned(skyDegrees_);
    return false;
  }
  if (motion_ == Motion::Orbit || motion_ == Motion::Look) leaveAxisView();
  if (motion_ == Motion::Orbit) {
    turnCamera(camera, pivot_, delta.x() * kDegreesPerPixel, -delta.y() * kDegreesPerPixel);
  } else if (motion_ == Motion::Look) {
    turnCamera(camera, eyeOf(camera), delta.x() * kLookDegreesPerPixel, -delta.y() * kLookDegreesPerPixel);
  } else if (motion_ == Motion::Pan) {
    const glm::dvec3 right = rightOf(camera), up = glm::cross(right, forwardOf(camera));
    const double half = camera->GetParallelProjection() != 0
                            ? camera->GetParallelScale()
                            : camera->GetDistance() * std::tan(glm::radians(0.5 * camera->GetViewAngle()));
    const double metresPerPixel = 2.0 * half / std::max(viewportHeight, 1.0);
    shiftCamera(camera, (-delta.x() * right + delta.y() * up) * metresPerPixel);
  } else {
    zoomCamera(camera, {eyeOf(camera), forwardOf(camera)}, camera->GetDistance(), std::pow(kZoomPerPixel, -delta.y()),
               0.0);
  }
  return true;
}

void CameraController::wheel(const QPointF& pixel, double steps) {
  if (motion_ == Motion::Look) {
    speed_ = std::clamp(speed_ * std::pow(1.2, steps), 0.05, 20.0);
    return;
  }
  vtkCamera* camera = hooks_.camera();
  const Ray ray = hooks_.ray(pixel);
  const auto met = hooks_.meet(ray);
  const double distance = met ? glm::length(*met - ray.origin) : camera->GetDistance();
  zoomCamera(camera, ray, distance, std::pow(kZoomPerStep, steps), kSmallestStep * diagonal() * std::abs(steps));
}

bool CameraController::takesKey(int key, Qt::KeyboardModifiers modifiers) const {
  if ((modifiers & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != 0) return false;
  if (key == Qt::Key_W || key == Qt::Key_A || key == Qt::Key_S || key == Qt::Key_D) return true;
  return motion_ == Motion::Look && (key == Qt::Key_E || key == Qt::Key_Q);
}

void CameraController::keyDown(int key, bool fast) {
  fast_ = fast;
  keys_.insert(key);
  if (timer_.isActive()) return;
  clock_.start();
  timer_.start();
}

void CameraController::keyUp(int key) {
  keys_.erase(key);
  if (keys_.empty()) timer_.stop();
}

void CameraController::stopFlying() {
  keys_.clear();
  timer_.stop();
}

void CameraController::setWalking(bool on) {
  walking_ = on;
  if (!on) return;
  leaveAxisView();
  standOnFloor(true);
  emit moved();
}

void CameraController::standOnFloor(bool any) {
  vtkCamera* camera = hooks_.camera();
  const glm::dvec3 eye = eyeOf(camera);
  if (const auto floor = hooks_.meet({eye, {0.0, -1.0, 0.0}})) {
    const double rise = floor->y + kEyeHeight - eye.y;
    if (any || rise < kHighestStep) shiftCamera(camera, {0.0, rise, 0.0});
  }
}

void CameraController::fly() {
  vtkCamera* camera = hooks_.camera();
  // A picture that took long is no reason to leap.
  const double seconds = std::min(clock_.restart() * 1e-3, 0.1);
  glm::dvec3 forward = forwardOf(camera), right = rightOf(camera);
  if (walking_) {
    forward.y = right.y = 0.0;
    if (glm::length(forward) > 1e-6) forward = glm::normalize(forward);
  }
  glm::dvec3 way(0.0);
  const auto held = [this](int key) { return keys_.count(key) > 0 ? 1.0 : 0.0; };
  way += forward * (held(Qt::Key_W) - held(Qt::Key_S)) + right * (held(Qt::Key_D) - held(Qt::Key_A));
  if (!walking_) way.y += held(Qt::Key_E) - held(Qt::Key_Q);
  if (glm::length(way) < 1e-9) return;
  leaveAxisView();
  const double pace = std::clamp(kFlightShare * diagonal(), kSlowest, kFastest);
  shiftCamera(camera, glm::normalize(way) * (pace * speed_ * (fast_ ? kFastTimes : 1.0) * seconds));
  if (walking_) standOnFloor(false);
  emit moved();
}

}  // namespace boxprobe
