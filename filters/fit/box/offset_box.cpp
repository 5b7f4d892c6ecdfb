// Probes and boxes relative to their origin: see fit_box.h.
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/fit_box.h"

namespace boxprobe {

OffsetBox offsetBox(const Probe& probe) {
  const glm::dvec3 pivot = probe.box.center();
  const glm::dvec3 origin = pivot + glm::transpose(rotationMatrix(probe.rotationDegrees)) * (probe.origin - pivot);
  OffsetBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.offset[static_cast<std::size_t>(2 * axis)] = origin[axis] - probe.box.min[axis];
    box.offset[static_cast<std::size_t>(2 * axis + 1)] = probe.box.max[axis] - origin[axis];
  }
  return box;
}

namespace {

/// The box along the axes of `rotation`, about `pivot`, that encloses another one.
Box enclosingBox(const Box& box, const glm::dvec3& oldPivot, const glm::dmat3& oldRotation, const glm::dvec3& pivot,
                 const glm::dmat3& rotation) {
  Box enclosing{glm::dvec3(1e300), glm::dvec3(-1e300)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                       (corner & 4) != 0 ? box.max.z : box.min.z);
    const glm::dvec3 world = oldPivot + oldRotation * (p - oldPivot);
    const glm::dvec3 q = pivot + glm::transpose(rotation) * (world - pivot);
    enclosing = {glm::min(enclosing.min, q), glm::max(enclosing.max, q)};
  }
  return enclosing;
}

}  // namespace

Box turnedInfluence(const Box& upright, const Probe& probe) {
  const glm::dvec3 pivot = probe.box.center();
  return enclosingBox(upright, pivot, glm::dmat3(1.0), pivot, rotationMatrix(probe.rotationDegrees));
}

Probe withOffsetBox(const Probe& probe, const OffsetBox& box, const glm::dvec3& rotationDegrees) {
  Probe fitted = probe;
  fitted.rotationDegrees = rotationDegrees;
  if (box.yaw != 0.0) {
    fitted.rotationDegrees.y = std::remainder(rotationDegrees.y + glm::degrees(box.yaw), 360.0);
  }
  const glm::dmat3 rotation = rotationMatrix(fitted.rotationDegrees);
  glm::dvec3 low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = -box.offset[static_cast<std::size_t>(2 * axis)];
    high[axis] = box.offset[static_cast<std::size_t>(2 * axis + 1)];
  }
  const glm::dvec3 middle = probe.origin + rotation * (0.5 * (low + high));
  fitted.box = {middle - 0.5 * (high - low), middle + 0.5 * (high - low)};
  if (fitted.rotationDegrees == glm::dvec3(0.0) && probe.rotationDegrees == glm::dvec3(0.0)) {
    // Keeps the digits of faces that did not move.
    const OffsetBox old = offsetBox(probe);
    for (int axis = 0; axis < 3; ++axis) {
      const auto face = static_cast<std::size_t>(2 * axis);
      if (box.offset[face] == old.offset[face]) fitted.box.min[axis] = probe.box.min[axis];
      if (box.offset[face + 1] == old.offset[face + 1]) fitted.box.max[axis] = probe.box.max[axis];
    }
  }
  if (probe.influence && (fitted.rotationDegrees != glm::dvec3(0.0) || probe.rotationDegrees != glm::dvec3(0.0))) {
    fitted.influence = enclosingBox(*probe.influence, probe.box.center(), rotationMatrix(probe.rotationDegrees),
                                    fitted.box.center(), rotation);
  }
  return fitted;
}

LookupErrors boxErrors(const FitPlace& place, const Probe& probe, int rays, double turn) {
  const LookupRays lookups =
      lookupRays(place, reflectedRays(place, probe, rays, turn), probe.origin, rotationMatrix(probe.rotationDegrees));
  return lookupErrors(lookups, offsetBox(probe));
}

}  // namespace boxprobe
