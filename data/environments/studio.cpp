// A photo studio for models that come without light: a key light in front to the left, a fill to the right, two rims
// behind, a soft top light, and a backdrop that runs into the floor without an edge. What the camera of a fitted object
// has behind it is calm.
#include "data/environments/studio.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "data/scenes/picture.h"

namespace boxprobe::environments {

namespace {

constexpr double kPi = 3.141592653589793;

/// Azimuth from +Z towards +X, elevation above the horizon.
glm::dvec3 towards(double azimuthDegrees, double elevationDegrees) {
  const double azimuth = glm::radians(azimuthDegrees), elevation = glm::radians(elevationDegrees);
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
}

/// A rectangle as seen from the middle, brightest in its centre, with soft edges.
struct Softbox {
  double azimuthDegrees, elevationDegrees, halfWidthDegrees, halfHeightDegrees, edgeDegrees;
  double fall;  ///< of the brightness from its centre to a corner
  glm::dvec3 radiance;

  glm::dvec3 seen(const glm::dvec3& direction) const {
    const glm::dvec3 middle = towards(azimuthDegrees, elevationDegrees);
    const double ahead = glm::dot(direction, middle);
    if (ahead <= 0.0) return glm::dvec3(0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), middle));
    const glm::dvec3 up = glm::cross(middle, right);
    const double x = glm::degrees(std::atan2(std::abs(glm::dot(direction, right)), ahead));
    const double y = glm::degrees(std::atan2(std::abs(glm::dot(direction, up)), ahead));
    const auto inside = [this](double angle, double half) {
      const double share = std::clamp((half + 0.5 * edgeDegrees - angle) / edgeDegrees, 0.0, 1.0);
      return share * share * (3.0 - 2.0 * share);
    };
    const double falloff = 1.0 - fall * std::min(1.0, (x * x) / (halfWidthDegrees * halfWidthDegrees) * 0.5 +
                                                          (y * y) / (halfHeightDegrees * halfHeightDegrees) * 0.5);
    return inside(x, halfWidthDegrees) * inside(y, halfHeightDegrees) * falloff * radiance;
  }
};

glm::dvec3 backdrop(double y) {
  const glm::dvec3 floor(0.34, 0.335, 0.33), horizon(0.58, 0.585, 0.595), top(0.24, 0.245, 0.255);
  const double share = std::abs(y);
  return y < 0.0 ? horizon + (floor - horizon) * std::sqrt(share) : horizon + (top - horizon) * share;
}

glm::dvec3 radiance(const glm::dvec3& direction) {
  static const std::vector<Softbox> boxes = {
      {-30.0, 42.0, 28.0, 20.0, 16.0, 0.6, {8.6, 8.25, 7.8}},  // key
      {80.0, 18.0, 22.0, 32.0, 20.0, 0.6, {1.5, 1.6, 1.75}},   // fill
      {160.0, 37.0, 9.0, 32.0, 8.0, 0.45, {5.4, 5.6, 6.0}},    // rim
      {-88.0, 28.0, 10.0, 36.0, 10.0, 0.45, {3.3, 3.4, 3.6}},  // second rim
  };
  glm::dvec3 sum = backdrop(direction.y);
  const double above = std::clamp((direction.y - 0.72) / 0.24, 0.0, 1.0);
  sum += above * above * (3.0 - 2.0 * above) * glm::dvec3(1.9, 1.95, 2.0);  // top light
  for (const Softbox& box : boxes) sum += box.seen(direction);
  // White paper that faces the camera of a fitted object then has a radiance of 0.94.
  constexpr double kLevel = 0.63;
  return kLevel * sum;
}

}  // namespace

std::string studioHdr() {
  constexpr int kWidth = 512, kHeight = 256;
  std::vector<float> rgb;
  rgb.reserve(static_cast<std::size_t>(3 * kWidth * kHeight));
  for (int row = 0; row < kHeight; ++row) {
    const double latitude = kPi * (0.5 - (row + 0.5) / kHeight);
    for (int column = 0; column < kWidth; ++column) {
      // OpenEXR's frame: longitude pi at the left edge, 0 along +Z in the middle.
      const double longitude = 2.0 * kPi * (0.5 - (column + 0.5) / kWidth);
      const glm::dvec3 color = radiance(
          {std::sin(longitude) * std::cos(latitude), std::sin(latitude), std::cos(longitude) * std::cos(latitude)});
      for (int channel = 0; channel < 3; ++channel) rgb.push_back(static_cast<float>(color[channel]));
    }
  }
  return scenes::hdrBytes(kWidth, kHeight, rgb);
}

}  // namespace boxprobe::environments
