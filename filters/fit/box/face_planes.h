// Candidates for the faces of a box: planes that many rays met.
#pragma once

#include <array>
#include <vector>

#include "filters/fit/box/lookup_rays.h"

namespace boxprobe {

/// A hit, relative to the capture origin, along the box's axes.
struct MetPoint {
  glm::dvec3 position{0.0}, normal{0.0};
  double weight = 0.0;
};

/// What the origin sees all around, and what reflected rays met; half of the weight each.
std::vector<MetPoint> metPoints(const FitPlace& place, const ReflectedRays& reflected, const glm::dvec3& originWorld,
                                const glm::dmat3& worldFromBox);
std::vector<MetPoint> turnedBy(const std::vector<MetPoint>& points, double yaw);

/// The yaw (radians, within 45 degrees) of walls at right angles: a quarter of the argument of the sum of w (nx + i
/// nz)^4 over upright surfaces.
struct UprightYaw {
  double yaw = 0.0;
  double strength = 0.0;  ///< 0: no direction stands out; 1: all walls agree
};
UprightYaw uprightYaw(const std::vector<MetPoint>& points);

/// A few offsets from the origin for each face, ascending: the highest peaks of a histogram of surfaces that face the
/// origin from that side, the 98 % quantile of everything on that side, and the end of the adjacent walls, which is the
/// plane of an opening.
struct FacePlanes {
  std::array<std::vector<double>, kFaces> offsets;
  std::array<double, kFaces> likeliest{};  ///< the highest peak, else the 98 % quantile; 0 where nothing was met
};
FacePlanes facePlanes(const std::vector<MetPoint>& points);

}  // namespace boxprobe
