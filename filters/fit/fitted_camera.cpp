// See fitted_camera.h.
#include "filters/fit/fitted_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

namespace boxprobe {

namespace {

const glm::dvec3 kWorldUp(0.0, 1.0, 0.0);

struct ViewAxes {
  glm::dvec3 forward, right, up;
};

ViewAxes axesTowards(const glm::dvec3& forward) {
  const glm::dvec3 right = glm::normalize(glm::cross(forward, kWorldUp));
  return {forward, right, glm::cross(right, forward)};
}

glm::dvec3 horizontally(double azimuthDegrees, double elevationDegrees) {
  const double azimuth = glm::radians(azimuthDegrees), elevation = glm::radians(elevationDegrees);
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
}

/// The direction from the target to the camera. Flat objects are seen more from their broad side.
glm::dvec3 flatteringSide(const glm::dvec3& size) {
  const double width = std::max(size.x, 1e-12), height = std::max(size.y, 1e-12), depth = std::max(size.z, 1e-12);
  const double flat = std::min(1.0, 4.0 * depth / std::max(width, height));  // 0: a picture on a wall
  const double lying = std::max(0.0, 1.0 - 4.0 * height / std::max(width, depth));
  const double thin = std::min(1.0, 4.0 * width / std::max(depth, height));  // 0: a picture seen along x
  return horizontally(90.0 - (90.0 - (10.0 + 22.0 * flat)) * thin, 18.0 + 22.0 * lying);
}

/// Rates the view from `eye` by a few rays: it should show front faces everywhere, at many distances, and nothing
/// close.
double viewScore(const TriangleRays& rays, const glm::dvec3& eye, const ViewAxes& axes, double tangent, double aspect,
                 double unit) {
  constexpr int kColumns = 9, kRows = 5;
  constexpr double kAll = kColumns * kRows;
  double sum = 0.0, squares = 0.0, close = 0.0;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const double x = (2.0 * (column + 0.5) / kColumns - 1.0) * tangent * aspect;
      const double y = (2.0 * (row + 0.5) / kRows - 1.0) * tangent;
      const std::optional<SurfaceHit> hit =
          rays.first(eye, glm::normalize(axes.forward + x * axes.right + y * axes.up));
      if (!hit) continue;  // sky is neutral
      const double distance = hit->distance / unit, far = std::log2(1.0 + distance);
      close += hit->back || distance < 0.35 ? 2.0 : distance < 0.6 ? 0.7 : 0.0;
      sum += far;
      squares += far * far;
    }
  }
  const double mean = sum / kAll;
  return mean + 1.5 * std::sqrt(std::max(0.0, squares / kAll - mean * mean)) - close / kAll;
}

}  // namespace

Camera objectCamera(const std::vector<glm::dvec3>& corners, const Box& bounds, double aspect) {
  constexpr double kFilled = 0.88;
  Camera camera;
  camera.verticalFovDegrees = 35.0;
  const ViewAxes axes = axesTowards(-flatteringSide(bounds.size()));
  const double tangent = std::tan(0.5 * glm::radians(camera.verticalFovDegrees));
  const double tall = kFilled * tangent, wide = std::min(kFilled, 0.94) * tangent * std::max(aspect, 0.1);
  // Every corner lies between the picture's edges: |x - eye| <= wide * (depth + distance), and likewise for y.
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  double right = kNone, left = kNone, top = kNone, bottom = kNone, nearest = kNone;
  const glm::dvec3 center = bounds.center();
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 from = corner - center;
    const double x = glm::dot(from, axes.right), y = glm::dot(from, axes.up), z = glm::dot(from, axes.forward);
    right = std::max(right, x - wide * z);
    left = std::max(left, -x - wide * z);
    top = std::max(top, y - tall * z);
    bottom = std::max(bottom, -y - tall * z);
    nearest = std::max(nearest, -z);
  }
  const double radius = std::max(0.5 * glm::length(bounds.size()), 1e-6);
  if (corners.empty()) right = left = top = bottom = nearest = radius;
  const double distance =
      std::max({(right + left) / (2.0 * wide), (top + bottom) / (2.0 * tall), nearest + 0.05 * radius});
  const glm::dvec3 aside = 0.5 * (right - left) * axes.right + 0.5 * (top - bottom) * axes.up;
  camera.target = center + aside;
  camera.position = camera.target - distance * axes.forward;
  return camera;
}

Camera roomCamera(const TriangleRays& rays, const std::vector<StandingPoint>& stands, double aspect) {
  constexpr std::size_t kStands = 40;
  constexpr int kTurns = 12;
  Camera camera;
  camera.verticalFovDegrees = 60.0;
  const double tangent = std::tan(0.5 * glm::radians(camera.verticalFovDegrees));
  double best = -std::numeric_limits<double>::infinity();
  const std::size_t step = std::max<std::size_t>(1, stands.size() / kStands);
  for (std::size_t i = 0; i < stands.size(); i += step) {
    const StandingPoint& stand = stands[i];
    if (i > 0 && stand.clearance < 0.08 * stand.height) continue;
    for (int turn = 0; turn < kTurns; ++turn) {
      const glm::dvec3 forward = horizontally(360.0 * turn / kTurns, -4.0);
      const double worth =
          viewScore(rays, stand.eyeWorld, axesTowards(forward), tangent, aspect, std::max(stand.height, 1e-12));
      if (worth <= best) continue;
      best = worth;
      const std::optional<SurfaceHit> ahead = rays.first(stand.eyeWorld, forward);
      camera.position = stand.eyeWorld;
      camera.target = stand.eyeWorld + forward * (ahead ? 0.6 * ahead->distance : stand.height);
    }
  }
  return camera;
}

}  // namespace boxprobe
