// See camera_moves.h.
#include "app/gui/view/camera_moves.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace boxprobe {

namespace {

constexpr double kMostElevation = 89.0;  ///< degrees; at the pole the vertical has no direction on the screen
constexpr double kBesideBox = 1.08;      ///< a little room about what is framed
// Focal points and parallel views, scene units: nearer and farther than that a camera has no direction any more.
constexpr double kNearest = 1e-9, kFarthest = 1e10;

glm::dvec3 vec3Of(const double* v) {
  return {v[0], v[1], v[2]};
}

/// Rodrigues' rotation; `axis` of unit length.
glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double degrees) {
  const double angle = glm::radians(degrees), c = std::cos(angle), s = std::sin(angle);
  return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
}

void placeCamera(vtkCamera* camera, const glm::dvec3& eye, const glm::dvec3& target) {
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(target.x, target.y, target.z);
}

}  // namespace

glm::dvec3 eyeOf(vtkCamera* camera) {
  return vec3Of(camera->GetPosition());
}

glm::dvec3 forwardOf(vtkCamera* camera) {
  return glm::normalize(vec3Of(camera->GetDirectionOfProjection()));
}

glm::dvec3 rightOf(vtkCamera* camera) {
  return glm::normalize(glm::cross(forwardOf(camera), vec3Of(camera->GetViewUp())));
}

void shiftCamera(vtkCamera* camera, const glm::dvec3& by) {
  placeCamera(camera, eyeOf(camera) + by, vec3Of(camera->GetFocalPoint()) + by);
}

void turnCamera(vtkCamera* camera, const glm::dvec3& pivot, double yawDegrees, double pitchDegrees) {
  const glm::dvec3 up = glm::normalize(vec3Of(camera->GetViewUp()));
  const double elevation = glm::degrees(std::asin(std::clamp(glm::dot(forwardOf(camera), up), -1.0, 1.0)));
  const double raised =
      std::clamp(elevation + pitchDegrees, std::min(elevation, -kMostElevation), std::max(elevation, kMostElevation));
  const glm::dvec3 right = rightOf(camera);
  const auto turned = [&](const glm::dvec3& v) {
    return rotated(rotated(v, right, raised - elevation), up, -yawDegrees);
  };
  const glm::dvec3 target = vec3Of(camera->GetFocalPoint());
  placeCamera(camera, pivot + turned(eyeOf(camera) - pivot), pivot + turned(target - pivot));
}

void zoomCamera(vtkCamera* camera, const Ray& ray, double distance, double factor, double smallestStep) {
  const glm::dvec3 forward = forwardOf(camera);
  if (camera->GetParallelProjection() != 0) {
    // The point keeps its pixel: the picture shrinks towards it.
    const glm::dvec3 beside = ray.origin - eyeOf(camera);
    const double before = camera->GetParallelScale(), after = std::clamp(before / factor, kNearest, kFarthest);
    shiftCamera(camera, (beside - glm::dot(beside, forward) * forward) * (1.0 - after / before));
    camera->SetParallelScale(after);
    return;
  }
  if (factor < 1.0 && distance > kFarthest) return;
  double step = distance * (1.0 - 1.0 / factor);
  if (std::abs(step) < smallestStep) step = std::copysign(smallestStep, factor - 1.0);
  const glm::dvec3 eye = eyeOf(camera) + step * ray.direction;
  const double least = std::max({smallestStep, kNearest, kNearest * glm::length(eye)});
  const double depth = std::max((distance - step) * glm::dot(ray.direction, forward), least);
  placeCamera(camera, eye, eye + depth * forward);
}

void frameBox(vtkCamera* camera, const Box& bounds, double aspect) {
  const double radius = std::max(0.5 * glm::length(bounds.size()), 1e-3) * kBesideBox;
  const glm::dvec3 center = bounds.center(), forward = forwardOf(camera);
  const double narrow = std::min(aspect, 1.0);
  if (camera->GetParallelProjection() != 0) camera->SetParallelScale(radius / narrow);
  const double half = std::atan(std::tan(glm::radians(0.5 * camera->GetViewAngle())) * narrow);
  placeCamera(camera, center - forward * (radius / std::sin(half)), center);
}

void lookAlong(vtkCamera* camera, const BoxFace& face, const Box& bounds, double aspect) {
  glm::dvec3 out(0.0);
  out[face.axis] = face.sign();
  // From above, -Z is up on the screen, as on a plan.
  const glm::dvec3 up = face.axis == 1 ? glm::dvec3(0.0, 0.0, face.positive ? -1.0 : 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 size = bounds.size();
  const double across = face.axis == 0 ? size.z : size.x, high = face.axis == 1 ? size.z : size.y;
  camera->SetParallelProjection(1);
  camera->SetParallelScale(0.5 * std::max({high, across / std::max(aspect, 1e-3), 1e-3}) * kBesideBox);
  camera->SetViewUp(up.x, up.y, up.z);
  const glm::dvec3 center = bounds.center();
  placeCamera(camera, center + out * std::max(glm::length(size), 1e-2), center);
}

}  // namespace boxprobe
