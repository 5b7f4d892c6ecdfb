// The angles of a rotation matrix, as a probe stores them.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace boxprobe {

/// The equivalent angle from -180 to 180 degrees.
inline double wrappedDegrees(double degrees) {
  return degrees - 360.0 * std::round(degrees / 360.0);
}

/// Degrees about X, then Y, then Z (world axes) that make `rotation`; of the two solutions, the one with the smaller
/// angles about X and Z. The inverse of rotationMatrix().
inline glm::dvec3 rotationDegreesOf(const glm::dmat3& rotation) {
  // rotation = Z Y X; its first column is (cos y cos z, cos y sin z, -sin y).
  const double y = std::asin(std::clamp(-rotation[0].z, -1.0, 1.0));
  const bool pole = std::abs(rotation[0].z) > 1.0 - 1e-12;
  // At the pole (gimbal lock) X and Z rotate about the same line: X gets the whole angle.
  const double x = pole ? std::atan2(-rotation[2].y, rotation[1].y) : std::atan2(rotation[1].z, rotation[2].z);
  const double z = pole ? 0.0 : std::atan2(rotation[0].y, rotation[0].x);
  const glm::dvec3 one = glm::degrees(glm::dvec3(x, y, z));
  const glm::dvec3 other(wrappedDegrees(one.x + 180.0), wrappedDegrees(180.0 - one.y), wrappedDegrees(one.z + 180.0));
  const auto tilt = [](const glm::dvec3& d) { return std::abs(d.x) + std::abs(d.z); };
  return !pole && tilt(other) < tilt(one) ? other : one;
}

}  // namespace boxprobe
