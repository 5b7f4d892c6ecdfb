// How wrong a box is: reflected rays as a probe sees them, and the angle between what the box would look up and what is
// truly there - the debug view *Lookup error*. Called by everything that searches a box.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <vector>

#include "filters/fit/box/reflected_rays.h"

namespace boxprobe {

/// Faces in the order of Probe handles: -x +x -y +y -z +z.
inline constexpr int kFaces = 6;
/// "-x" to "+z".
const char* faceName(int face);

/// Relative to the capture origin, along the box's axes.
struct LookupRay {
  glm::dvec3 from{0.0}, along{0.0};
  glm::dvec3 target{0.0};  ///< unit, from the origin to what the ray meets
  double weight = 0.0;
  std::size_t reflected = 0;  ///< which of the reflected rays it was made from
};

struct LookupRays {
  std::vector<LookupRay> rays;  ///< those whose end the origin sees; weights sum to 1
  double hidden = 0.0;          ///< share of the weight whose end it does not see: no box puts that right
};

/// A box relative to the capture origin, turned by `yaw` (radians) against the axes of the rays, about the origin.
struct OffsetBox {
  std::array<double, kFaces> offset{};  ///< distance of each face from the origin, along its own outward direction
  double yaw = 0.0;
};

/// The rays that a probe at `originWorld` can be judged by; `worldFromBox`: the axes to hold them in.
LookupRays lookupRays(const FitPlace& place, const ReflectedRays& reflected, const glm::dvec3& originWorld,
                      const glm::dmat3& worldFromBox);

/// The same rays along axes that are turned by `yaw` (radians, about +y).
LookupRays turnedBy(const LookupRays& rays, double yaw);

/// Every n-th, such that about `count` are left, with the weights of all.
LookupRays someOf(const LookupRays& rays, std::size_t count);

/// Where a ray leaves the box: shaders/shared/slab.glsl in double.
struct BoxExit {
  double distance = 0.0;  ///< along the ray; 0 where it starts beyond the face
  int face = 0;
};
BoxExit boxExit(const LookupRay& ray, const std::array<double, kFaces>& offset);

/// Radians between what is looked up after `distance` along the ray and what is there.
double lookupError(const LookupRay& ray, double distance);

/// Weighted mean, degrees. The yaw of `box` counts.
double meanError(const LookupRays& rays, const OffsetBox& box);

/// What a reflection counts whose end the origin does not see: what is looked up there shows something else. A lookup
/// that is further off is no worse.
inline constexpr double kHiddenDegrees = 20.0;

struct LookupErrors {
  double meanDegrees = 0.0, p95Degrees = 0.0;
  double above5 = 0.0;  ///< share of the weight with more than 5 degrees
};
LookupErrors lookupErrors(const LookupRays& rays, const OffsetBox& box);

/// Degrees by which the mean changes per scene unit that a face moves, as rays leave through it: the sum of
/// w sin(angle(along, d)) / (|d| |cos|), with d what is looked up and cos the ray's slope against the face.
std::array<double, kFaces> faceSensitivities(const LookupRays& rays, const OffsetBox& box);

}  // namespace boxprobe
