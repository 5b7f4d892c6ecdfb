// Where each face of a box may lie: planes that many rays met. Called by fit_box.
#pragma once

#include <array>
#include <vector>

#include "filters/fit/box/lookup_rays.h"

namespace boxprobe {

/// What was met, relative to the capture origin, along the box's axes.
struct MetPoint {
  glm::dvec3 position{0.0}, normal{0.0};
  double weight = 0.0;
};

/// What the origin sees all around and what reflected rays met, half of the weight each.
std::vector<MetPoint> metPoints(const FitPlace& place, const ReflectedRays& reflected, const glm::dvec3& originWorld,
                                const glm::dmat3& worldFromBox);
std::vector<MetPoint> turnedBy(const std::vector<MetPoint>& points, double yaw);

/// The yaw (radians, within 45 degrees) of walls that stand at right angles: a quarter of the argument of the sum of
/// w (nx + i nz)^4 over surfaces that stand upright.
struct UprightYaw {
  double yaw = 0.0;
  double strength = 0.0;  ///< 0: no direction stands out; 1: every wall agrees
};
UprightYaw uprightYaw(const std::vector<MetPoint>& points);

/// For each face some offsets from the origin, ascending: the highest peaks of a histogram of surfaces that face the
/// origin from that side, how far 98 % of everything on that side reaches, and the end of the walls beside it, which is
/// the plane of an opening.
struct FacePlanes {
  std::array<std::vector<double>, kFaces> offsets;
  std::array<double, kFaces> likeliest{};  ///< the highest peak; without one, those 98 %; 0 where nothing was met
};
FacePlanes facePlanes(const std::vector<MetPoint>& points);

}  // namespace boxprobe
