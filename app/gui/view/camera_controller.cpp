// See camera_controller.h.
#include "app/gui/view/camera_controller.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace boxprobe {

namespace {

constexpr double kDegreesPerPixel = 0.35;
constexpr double kZoomPerStep = 1.12;
constexpr double kZoomPerPixel = 1.008;
constexpr double kSmallestDistance = 1e-3;  ///< metres; closer, the direction of view would be lost to rounding
constexpr double kLargestElevation = 89.0;  ///< degrees; at the pole the vertical has no direction on the screen

glm::dvec3 vec(const double* v) {
  return {v[0], v[1], v[2]};
}

void orbit(vtkCamera* camera, const QPointF& delta) {
  const glm::dvec3 up = glm::normalize(vec(camera->GetViewUp()));
  const glm::dvec3 target = vec(camera->GetFocalPoint());
  const glm::dvec3 arm = vec(camera->GetPosition()) - target;
  const double distance = glm::length(arm);
  const double elevation = glm::degrees(std::asin(std::clamp(glm::dot(arm / distance, up), -1.0, 1.0)));
  const double raised = std::clamp(elevation + delta.y() * kDegreesPerPixel, std::min(elevation, -kLargestElevation),
                                   std::max(elevation, kLargestElevation));
  camera->Azimuth(-delta.x() * kDegreesPerPixel);
  camera->Elevation(raised - elevation);
}

void pan(vtkCamera* camera, const QPointF& delta, double viewportHeight) {
  const glm::dvec3 forward = vec(camera->GetDirectionOfProjection());
  const glm::dvec3 right = glm::normalize(glm::cross(forward, vec(camera->GetViewUp())));
  const glm::dvec3 up = glm::cross(right, forward);
  const double heightAtTarget = 2.0 * camera->GetDistance() * std::tan(glm::radians(0.5 * camera->GetViewAngle()));
  const double metresPerPixel = heightAtTarget / std::max(viewportHeight, 1.0);
  const glm::dvec3 shift = (-delta.x() * right + delta.y() * up) * metresPerPixel;
  const glm::dvec3 position = vec(camera->GetPosition()) + shift;
  const glm::dvec3 target = vec(camera->GetFocalPoint()) + shift;
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(target.x, target.y, target.z);
}

void dolly(vtkCamera* camera, double factor) {
  if (camera->GetDistance() / factor > kSmallestDistance) camera->Dolly(factor);
}

}  // namespace

void CameraController::begin(Motion motion, const QPointF& pixel) {
  motion_ = motion;
  last_ = pixel;
}

bool CameraController::move(vtkCamera* camera, const QPointF& pixel, double viewportHeight) {
  const QPointF delta = pixel - last_;
  last_ = pixel;
  if (motion_ == Motion::None || delta.isNull()) return false;
  if (motion_ == Motion::Orbit) orbit(camera, delta);
  if (motion_ == Motion::Pan) pan(camera, delta, viewportHeight);
  if (motion_ == Motion::Zoom) dolly(camera, std::pow(kZoomPerPixel, -delta.y()));
  return true;
}

void CameraController::zoom(vtkCamera* camera, double steps) {
  dolly(camera, std::pow(kZoomPerStep, steps));
}

}  // namespace boxprobe
