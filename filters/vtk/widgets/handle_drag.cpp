#include "filters/vtk/widgets/handle_drag.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/rotation_degrees.h"
#include "filters/vtk/widgets/handle_picking.h"

namespace boxprobe {

namespace {

/// Along its own axis, in the frame of the box.
void moveFace(Box& box, const BoxFace& face, double outwards) {
  (face.positive ? box.max : box.min)[face.axis] += face.sign() * outwards;
}

}  // namespace

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

AxisDrag::AxisDrag(const glm::dvec3& point, const glm::dvec3& axis, const ViewAxes& view, const Ray& grab)
    : point_(point), axis_(axis), view_(view) {
  // Looking along the axis, the closest point would jump from the viewer to the horizon within a few pixels.
  constexpr double kHeadOnCosine = 0.985;  // 10 degrees
  headOn_ = std::abs(glm::dot(axis_, grab.direction)) > kHeadOnCosine;
  grabOffset_ = along(grab).value_or(0.0);
}

std::optional<double> AxisDrag::along(const Ray& ray) const {
  if (!headOn_) return closestOnLine(ray, point_, axis_);
  const auto met = meetPlane(ray, point_, view_.forward);
  if (!met) return std::nullopt;
  const double away = glm::dot(*met - point_, view_.up);
  return glm::dot(axis_, view_.forward) > 0.0 ? away : -away;
}

double AxisDrag::offset(const Ray& ray) {
  if (const auto at = along(ray)) offset_ = *at - grabOffset_;
  return offset_;
}

ProbeDrag::ProbeDrag(const Probe& probe, const Handle& handle, const ViewAxes& view, const Ray& grab, double thinnest)
    : start_(probe),
      handle_(handle),
      view_(view),
      grab_(grab),
      thinnest_(thinnest),
      line_(handleAnchorWorld(probe, handle), handleAxisWorld(probe, handle), view, grab),
      originWorld_(probe.origin) {}

Probe ProbeDrag::at(const DragWish& wish) {
  switch (handle_.kind) {
    case HandleKind::Face:
    case HandleKind::Influence:
    case HandleKind::Blend:
      return faceAt(wish);
    case HandleKind::Move:
    case HandleKind::OriginAxis:
      return movedAt(wish);
    case HandleKind::Turn:
      return turnedAt(wish);
    case HandleKind::Origin:
      break;
  }
  return originAt(wish);
}

Probe ProbeDrag::faceAt(const DragWish& wish) {
  double offset = line_.offset(wish.ray);
  if (wish.snap != nullptr) offset = wish.snap->face(line_.point(), line_.axis(), offset, start_.origin);
  Probe probe = start_;
  const BoxFace& face = handle_.face;
  const BoxFace opposite{face.axis, !face.positive};
  if (handle_.kind == HandleKind::Face) {
    setBox(probe, withFaceMoved(start_.box, start_.rotationDegrees, face, offset, wish.symmetric, thinnest_));
  } else if (handle_.kind == HandleKind::Influence) {
    // It is rotated about the projection box's centre, which stays: so do its other faces.
    Box influence = start_.influenceBox();
    const double size = influence.size()[face.axis];
    const double thinnest = std::min(thinnest_, size);
    const double outwards = std::max(offset, (thinnest - size) / (wish.symmetric ? 2.0 : 1.0));
    moveFace(influence, face, outwards);
    if (wish.symmetric) moveFace(influence, opposite, outwards);
    probe.influence = influence;
  } else {
    const auto inwards = [&](const BoxFace& of) {
      double& distance = (of.positive ? probe.blendDistance.max : probe.blendDistance.min)[face.axis];
      distance = std::clamp(distance - offset, 0.0, start_.influenceBox().size()[face.axis]);
    };
    inwards(face);
    if (wish.symmetric) inwards(opposite);
  }
  return probe;
}

Probe ProbeDrag::movedAt(const DragWish& wish) {
  double offset = line_.offset(wish.ray);
  if (wish.snap != nullptr) offset = wish.snap->grid(line_.point(), line_.axis(), offset);
  const glm::dvec3 by = offset * line_.axis();
  if (handle_.kind == HandleKind::Move) return movedProbe(start_, by);
  Probe probe = start_;
  probe.origin += by;
  return probe;
}

double ProbeDrag::turnDegrees(const Ray& ray) {
  const glm::dvec3& center = line_.point();
  const glm::dvec3& axis = line_.axis();
  constexpr double kEdgeOnCosine = 0.1;  // a ring seen edge-on: uses its tangent instead of its plane
  const auto from = meetPlane(grab_, center, axis);
  if (!from || std::abs(glm::dot(grab_.direction, axis)) < kEdgeOnCosine) {
    const glm::dvec3 across = glm::cross(axis, -view_.forward);
    if (glm::length(across) < 1e-9) return degrees_;
    const glm::dvec3 tangent = glm::normalize(across);
    const auto grabbed = closestOnLine(grab_, center, tangent), now = closestOnLine(ray, center, tangent);
    const double arm = glm::length(start_.box.size()) * 0.25;
    if (grabbed && now && arm > 0.0) degrees_ = glm::degrees((*now - *grabbed) / arm);
    return degrees_;
  }
  const auto to = meetPlane(ray, center, axis);
  if (!to) return degrees_;
  const glm::dvec3 a = *from - center, b = *to - center;
  degrees_ = glm::degrees(std::atan2(glm::dot(glm::cross(a, b), axis), glm::dot(a, b)));
  return degrees_;
}

Probe ProbeDrag::turnedAt(const DragWish& wish) {
  double degrees = turnDegrees(wish.ray);
  const glm::dvec3& was = start_.rotationDegrees;
  const bool yawAlone = handle_.face.axis == 1 && was.x == 0.0 && was.z == 0.0;
  if (wish.snap != nullptr) {
    const double base = yawAlone ? was.y : 0.0;
    const double step = wish.snap->turnStepDegrees();
    degrees = step * std::round((base + degrees) / step) - base;
  }
  Probe probe = start_;
  const glm::dmat3 before = rotationMatrix(was);
  glm::dvec3 turn(0.0);
  turn[handle_.face.axis] = degrees;
  // Rotates about one of its own axes: first in the box's frame, then by the original rotation.
  const glm::dmat3 after = before * rotationMatrix(turn);
  probe.rotationDegrees = yawAlone ? glm::dvec3(0.0, wrappedDegrees(was.y + degrees), 0.0) : rotationDegreesOf(after);
  const glm::dvec3 center = start_.box.center();
  probe.origin = center + after * (glm::transpose(before) * (start_.origin - center));
  return probe;
}

Probe ProbeDrag::originAt(const DragWish& wish) {
  if (wish.axis) {
    glm::dvec3 direction(0.0);
    direction[*wish.axis] = 1.0;
    const auto from = closestOnLine(grab_, start_.origin, direction);
    const auto to = closestOnLine(wish.ray, start_.origin, direction);
    if (from && to) originWorld_ = start_.origin + (*to - *from) * direction;
  } else {
    const auto from = meetPlane(grab_, start_.origin, view_.forward);
    const auto to = meetPlane(wish.ray, start_.origin, view_.forward);
    if (from && to) originWorld_ = start_.origin + (*to - *from);
  }
  Probe probe = start_;
  probe.origin = wish.snap != nullptr ? wish.snap->grid(originWorld_) : originWorld_;
  if (wish.axis) {
    for (int axis = 0; axis < 3; ++axis) {
      if (axis != *wish.axis) probe.origin[axis] = start_.origin[axis];
    }
  }
  return probe;
}

bool isFace(const Handle& handle) {
  return handle.kind == HandleKind::Face || handle.kind == HandleKind::Influence || handle.kind == HandleKind::Blend;
}

Probe nudgedProbe(const Probe& probe, const Handle& handle, const glm::dvec3& by, const ViewAxes& view) {
  if (isFace(handle)) {
    // A ray offset by the face's movement gives the distance.
    const glm::dvec3 axis = handleAxisWorld(probe, handle);
    const glm::dvec3 anchor = handleAnchorWorld(probe, handle);
    const glm::dvec3 side = std::abs(axis.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 across = glm::normalize(glm::cross(axis, side));
    const Ray from{anchor - across, across};
    ProbeDrag along(probe, handle, view, from);
    const Ray to{from.origin + glm::dot(by, axis) * axis, across};
    return along.at({to, false, std::nullopt, nullptr});
  }
  if (handle.kind == HandleKind::Move) return movedProbe(probe, by);
  Probe moved = probe;
  moved.origin += by;
  return moved;
}

Probe movedProbe(const Probe& probe, const glm::dvec3& by) {
  Probe moved = probe;
  moved.origin += by;
  moved.box.min += by;
  moved.box.max += by;
  if (moved.influence) {
    moved.influence->min += by;
    moved.influence->max += by;
  }
  return moved;
}

bool movesOthers(HandleKind kind) {
  return kind == HandleKind::Move || kind == HandleKind::Turn || kind == HandleKind::Origin ||
         kind == HandleKind::OriginAxis;
}

Probe movedAlong(const Probe& other, HandleKind kind, const Probe& start, const Probe& now) {
  if (kind == HandleKind::Move) return movedProbe(other, now.box.center() - start.box.center());
  Probe moved = other;
  if (kind != HandleKind::Turn) {
    moved.origin += now.origin - start.origin;
    return moved;
  }
  const glm::dmat3 turn = rotationMatrix(now.rotationDegrees) * glm::transpose(rotationMatrix(start.rotationDegrees));
  const glm::dvec3 pivot = start.box.center();
  const auto turned = [&](const glm::dvec3& point) { return pivot + turn * (point - pivot); };
  moved = movedProbe(other, turned(other.box.center()) - other.box.center());
  moved.origin = turned(other.origin);
  const auto upright = [](const Probe& probe) {
    return probe.rotationDegrees.x == 0.0 && probe.rotationDegrees.z == 0.0;
  };
  if (upright(other) && upright(start) && upright(now)) {
    const double yaw = other.rotationDegrees.y + now.rotationDegrees.y - start.rotationDegrees.y;
    moved.rotationDegrees = {0.0, wrappedDegrees(yaw), 0.0};
  } else {
    moved.rotationDegrees = rotationDegreesOf(turn * rotationMatrix(other.rotationDegrees));
  }
  return moved;
}

}  // namespace boxprobe
