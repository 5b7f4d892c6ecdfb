// Rates boxes: reflected rays as a probe sees them, and the angle between what the box would sample and what is truly
// there, as in the debug view *Lookup error*.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <vector>

#include "filters/fit/box/reflected_rays.h"

namespace boxprobe {

/// Faces in the order of the probe's handles: -x +x -y +y -z +z.
inline constexpr int kFaces = 6;
/// "-x" to "+z".
const char* faceName(int face);

/// Relative to the capture origin, along the box's axes.
struct LookupRay {
  glm::dvec3 from{0.0}, along{0.0};
  glm::dvec3 target{0.0};  ///< unit, from the origin to what the ray meets
  double weight = 0.0;
  std::size_t reflected = 0;  ///< index of the reflected ray
};

struct LookupRays {
  std::vector<LookupRay> rays;  ///< those whose end the origin sees; weights sum to 1
  double hidden = 0.0;          ///< share of the weight whose end it does not see: no box can fix it
};

/// A box relative to the capture origin, rotated by `yaw` (radians) about the origin against the axes of the rays.
struct OffsetBox {
  std::array<double, kFaces> offset{};  ///< distance of each face from the origin, along its outward direction
  double yaw = 0.0;
};

/// The rays by which a probe at `originWorld` can be rated; `worldFromBox`: the axes to express them in.
LookupRays lookupRays(const FitPlace& place, const ReflectedRays& reflected, const glm::dvec3& originWorld,
                      const glm::dmat3& worldFromBox);

/// The same rays along axes rotated by `yaw` (radians, about +y).
LookupRays turnedBy(const LookupRays& rays, double yaw);

/// Every n-th ray, such that about `count` are left, with the total weight unchanged.
LookupRays someOf(const LookupRays& rays, std::size_t count);

/// Where a ray leaves the box: shaders/shared/slab.glsl in double.
struct BoxExit {
  double distance = 0.0;  ///< along the ray; 0 if it starts beyond the face
  int face = 0;
};
BoxExit boxExit(const LookupRay& ray, const std::array<double, kFaces>& offset);

/// The angle in radians between what is sampled after `distance` along the ray and what is there.
double lookupError(const LookupRay& ray, double distance);

/// Weighted mean in degrees; takes the yaw of `box` into account.
double meanError(const LookupRays& rays, const OffsetBox& box);

/// The error assigned to a reflection whose end the origin does not see: the lookup shows something else. Also the
/// maximum error of a lookup.
inline constexpr double kHiddenDegrees = 20.0;

struct LookupErrors {
  double meanDegrees = 0.0, p95Degrees = 0.0;
  double above5 = 0.0;  ///< share of the weight with errors above 5 degrees
};
LookupErrors lookupErrors(const LookupRays& rays, const OffsetBox& box);

/// Degrees by which the mean changes per scene unit that a face moves, for the rays that leave through it: the sum of w
/// sin(angle(along, d)) / (|d| |cos|), where d is the sampled vector and cos the cosine between the ray and the face's
/// normal.
std::array<double, kFaces> faceSensitivities(const LookupRays& rays, const OffsetBox& box);

}  // namespace boxprobe
