// See handle_drag.h.
#include "app/gui/handles/handle_drag.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

std::optional<double> closestOnLine(const Ray& ray, const glm::dvec3& point, const glm::dvec3& axis) {
  // Two lines are closest where the segment between them is perpendicular to both.
  const glm::dvec3 between = point - ray.origin;
  const double cosine = glm::dot(axis, ray.direction);
  const double sineSquared = 1.0 - cosine * cosine;
  constexpr double kParallel = 7.6e-5;  // sin² of 0.5 degrees
  if (sineSquared < kParallel) return std::nullopt;
  const double alongRay = (glm::dot(ray.direction, between) - cosine * glm::dot(axis, between)) / sineSquared;
  if (alongRay < 0.0) return std::nullopt;  // past the line's vanishing point
  return (cosine * glm::dot(ray.direction, between) - glm::dot(axis, between)) / sineSquared;
}

std::optional<glm::dvec3> meetPlane(const Ray& ray, const glm::dvec3& point, const glm::dvec3& normal) {
  const double along = glm::dot(ray.direction, normal);
  if (std::abs(along) < 1e-6) return std::nullopt;
  const double distance = glm::dot(point - ray.origin, normal) / along;
  if (distance < 0.0) return std::nullopt;
  return ray.origin + distance * ray.direction;
}

FaceDrag::FaceDrag(const Probe& probe, const BoxFace& face, const ViewAxes& view, const Ray& grab)
    : start_(probe.box),
      rotationDegrees_(probe.rotationDegrees),
      face_(face),
      centerWorld_(faceCenterWorld(probe, face)),
      axisWorld_(faceAxisWorld(probe, face)),
      view_(view) {
  // Looking along the axis the closest point leaps from the viewer's nose to the horizon within a few pixels.
  constexpr double kHeadOnCosine = 0.985;  // 10 degrees
  headOn_ = std::abs(glm::dot(axisWorld_, grab.direction)) > kHeadOnCosine;
  grabOffset_ = alongAxis(grab).value_or(0.0);
}

std::optional<double> FaceDrag::alongAxis(const Ray& ray) const {
  if (!headOn_) return closestOnLine(ray, centerWorld_, axisWorld_);
  const auto met = meetPlane(ray, centerWorld_, view_.forward);
  if (!met) return std::nullopt;
  const double away = glm::dot(*met - centerWorld_, view_.up);
  return glm::dot(axisWorld_, view_.forward) > 0.0 ? away : -away;
}

Box FaceDrag::box(const Ray& ray, bool symmetric) {
  if (const auto along = alongAxis(ray)) offset_ = *along - grabOffset_;
  return withFaceMoved(start_, rotationDegrees_, face_, offset_, symmetric, kMinimumThickness);
}

OriginDrag::OriginDrag(const Probe& probe, const ViewAxes& view, const Ray& grab)
    : start_(probe.origin), planeNormal_(view.forward), grab_(grab), last_(probe.origin) {}

glm::dvec3 OriginDrag::origin(const Ray& ray, std::optional<int> axis) {
  if (axis) {
    glm::dvec3 direction(0.0);
    direction[*axis] = 1.0;
    const auto from = closestOnLine(grab_, start_, direction);
    const auto to = closestOnLine(ray, start_, direction);
    if (!from || !to) return last_;
    last_ = start_;
    last_[*axis] += *to - *from;
    return last_;
  }
  const auto from = meetPlane(grab_, start_, planeNormal_);
  const auto to = meetPlane(ray, start_, planeNormal_);
  if (from && to) last_ = start_ + (*to - *from);
  return last_;
}

}  // namespace boxprobe
