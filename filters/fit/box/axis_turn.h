// Rotation of vectors about +y.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace boxprobe {

/// Transforms into axes rotated by `yaw` (radians, about +y): the inverse of that rotation.
class AxisTurn {
 public:
  explicit AxisTurn(double yaw) : c_(std::cos(yaw)), s_(std::sin(yaw)) {}
  glm::dvec3 operator()(const glm::dvec3& v) const { return {c_ * v.x - s_ * v.z, v.y, s_ * v.x + c_ * v.z}; }

 private:
  double c_, s_;
};

}  // namespace boxprobe
