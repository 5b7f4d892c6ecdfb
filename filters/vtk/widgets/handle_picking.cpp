#include "filters/vtk/widgets/handle_picking.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

/// In the frame of the box.
glm::dvec3 faceCenterBox(const Box& box, const BoxFace& face) {
  glm::dvec3 center = box.center();
  center[face.axis] = face.positive ? box.max[face.axis] : box.min[face.axis];
  return center;
}

glm::dvec3 gripCenterBox(const Probe& probe, const Handle& handle) {
  if (handle.kind == HandleKind::Influence) return faceCenterBox(probe.influenceBox(), handle.face);
  // Off centre: without a blend distance it would coincide with the influence box's handle.
  const Box inner = fullWeightBox(probe);
  glm::dvec3 center = faceCenterBox(inner, handle.face);
  const int beside = (handle.face.axis + 1) % 3;
  center[beside] += 0.25 * inner.size()[beside];
  return center;
}

double pixelsToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * along);
}

/// Nothing for a point behind the viewer.
std::optional<double> pixelsTo(const std::vector<glm::dvec3>& grip, const ViewProjection& view, const glm::dvec2& p) {
  std::optional<double> nearest;
  std::optional<glm::dvec2> last;
  for (const glm::dvec3& point : grip) {
    const auto at = view.pixel(point);
    if (at) {
      const double pixels = last ? pixelsToSegment(p, *last, *at) : glm::length(*at - p);
      if (!nearest || pixels < *nearest) nearest = pixels;
    }
    last = at;
  }
  return nearest;
}

}  // namespace

std::vector<Handle> handles(const std::vector<Probe>& probes, std::optional<std::size_t> selected, HandleMode mode) {
  std::vector<Handle> all;
  if (selected && *selected < probes.size()) {
    const auto faces = [&](HandleKind kind) {
      for (const BoxFace& face : kBoxFaces) all.push_back({kind, *selected, face});
    };
    const auto axes = [&](HandleKind kind) {
      for (int axis = 0; axis < 3; ++axis) all.push_back({kind, *selected, {axis, true}});
    };
    if (mode == HandleMode::Box) faces(HandleKind::Face);
    if (mode == HandleMode::Influence) faces(HandleKind::Influence), faces(HandleKind::Blend);
    if (mode == HandleMode::Origin) axes(HandleKind::OriginAxis);
    if (mode == HandleMode::Place) axes(HandleKind::Move), axes(HandleKind::Turn);
  }
  for (std::size_t i = 0; i < probes.size(); ++i) all.push_back({HandleKind::Origin, i, {}});
  return all;
}

glm::dvec3 handleAnchorWorld(const Probe& probe, const Handle& handle) {
  switch (handle.kind) {
    case HandleKind::Face:
      return faceCenterWorld(probe, handle.face);
    case HandleKind::Influence:
    case HandleKind::Blend:
      return worldFromBox(rotationMatrix(probe.rotationDegrees), probe.box.center(), gripCenterBox(probe, handle));
    case HandleKind::Move:
    case HandleKind::Turn:
      return probe.box.center();
    case HandleKind::Origin:
    case HandleKind::OriginAxis:
      break;
  }
  return probe.origin;
}

glm::dvec3 handleAxisWorld(const Probe& probe, const Handle& handle) {
  glm::dvec3 axis(0.0);
  axis[handle.kind == HandleKind::Origin ? 1 : handle.face.axis] = 1.0;
  if (handle.kind == HandleKind::Origin || handle.kind == HandleKind::OriginAxis) return axis;
  return faceAxisWorld(probe, handle.face);
}

std::vector<glm::dvec3> handleGripWorld(const Probe& probe, const Handle& handle, const ViewProjection& view,
                                        double size) {
  const glm::dvec3 anchor = handleAnchorWorld(probe, handle);
  const double pixel = size * view.metresPerPixel(anchor);
  const glm::dvec3 axis = handleAxisWorld(probe, handle);
  if (handle.kind == HandleKind::Move || handle.kind == HandleKind::OriginAxis) {
    return {anchor + kArrowStartPixels * pixel * axis, anchor + kArrowPixels * pixel * axis};
  }
  if (handle.kind != HandleKind::Turn) return {anchor};
  const glm::dmat3 rotation = rotationMatrix(probe.rotationDegrees);
  const glm::dvec3 u = rotation[(handle.face.axis + 1) % 3], v = rotation[(handle.face.axis + 2) % 3];
  constexpr int kSides = 48;
  std::vector<glm::dvec3> ring;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = glm::radians(360.0 * i / kSides);
    ring.push_back(anchor + kRingPixels * pixel * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return ring;
}

std::optional<Handle> handleAt(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                               const ViewProjection& view, const glm::dvec2& pixel, double reachPixels, HandleMode mode,
                               double size) {
  std::optional<Handle> best;
  bool bestLine = false;
  double bestPixels = reachPixels;
  double bestDistance = 0.0;
  for (const Handle& handle : handles(probes, selected, mode)) {
    const auto grip = handleGripWorld(probes[handle.probe], handle, view, size);
    const bool line = grip.size() > 1;
    const auto pixels = pixelsTo(grip, view, pixel);
    if (!pixels || *pixels > reachPixels || (line && best && !bestLine)) continue;
    const double distance = glm::length(grip.front() - view.eyeWorld());
    constexpr double kSamePixels = 1.0;
    const bool over = best && bestLine && !line;
    const bool asNear = best && std::abs(*pixels - bestPixels) < kSamePixels;
    if (!over && (asNear ? distance >= bestDistance : *pixels > bestPixels)) continue;
    best = handle;
    bestLine = line;
    bestPixels = *pixels;
    bestDistance = distance;
  }
  return best;
}

}  // namespace boxprobe
