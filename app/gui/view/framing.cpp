// See framing.h.
#include "app/gui/view/framing.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "app/gui/view/camera_moves.h"
#include "filters/core/geometry/probe_frame.h"
#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

Box worldBoundsOf(const Probe& probe) {
  const auto corners = boxCornersWorld(probe.box, rotationMatrix(probe.rotationDegrees), probe.box.center());
  Box bounds{corners[0], corners[0]};
  for (const glm::dvec3& corner : corners) {
    bounds.min = glm::min(bounds.min, corner);
    bounds.max = glm::max(bounds.max, corner);
  }
  return bounds;
}

bool isIndoors(const glm::dvec3& positionWorld, const MeetSurface& meet) {
  // Most of five: under a skylight one is indoors, under a few beams not.
  constexpr double kTilt = 0.4;
  int met = 0;
  for (const auto& [x, z] : {std::pair(0.0, 0.0), {kTilt, 0.1}, {-kTilt, -0.1}, {0.1, -kTilt}, {-0.1, kTilt}}) {
    met += meet({positionWorld, glm::normalize(glm::dvec3(x, 1.0, z))}) ? 1 : 0;
  }
  return met >= 3;
}

std::optional<double> clearDistance(vtkCamera* camera, const Box& bounds, const MeetSurface& meet) {
  constexpr double kInner = 0.8;
  constexpr double kFromWall = 0.1, kFromWallShare = 0.05;  // metres, and of the way: the near plane must not cut it
  const glm::dvec3 center = bounds.center(), back = -forwardOf(camera), half = 0.5 * bounds.size();
  double edge = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(back[axis]) > 1.0e-9) edge = std::min(edge, half[axis] / std::abs(back[axis]));
  }
  const auto wall = meet({center + kInner * edge * back, back});
  const double distance = glm::length(eyeOf(camera) - center);
  const double clear = wall ? glm::length(*wall - center) : distance;
  if (clear >= distance) return std::nullopt;
  return std::max(clear - std::max(kFromWall, kFromWallShare * clear), 0.5 * clear);
}

}  // namespace boxprobe
