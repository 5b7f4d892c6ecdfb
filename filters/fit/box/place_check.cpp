// See place_check.h.
#include "filters/fit/box/place_check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

constexpr int kLooks = 512;

double medianOf(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double walledAround(const SurfaceRays& rays, const glm::dvec3& originWorld) {
  double all = 0.0, walls = 0.0;
  for (const glm::dvec3& direction : fibonacciDirections(kLooks)) {
    if (std::abs(direction.y) > 0.5) continue;
    all += 1.0;
    const std::optional<SurfaceHit> hit = rays.first(originWorld, direction);
    if (hit && std::abs(hit->normalWorld.y) < 0.7) walls += 1.0;
  }
  return walls / all;
}

bool insideOfSolid(const SurfaceRays& rays, const glm::dvec3& originWorld) {
  std::vector<double> near, beyond;
  double fronts = 0.0;
  for (const glm::dvec3& direction : fibonacciDirections(kLooks)) {
    const std::optional<SurfaceHit> hit = rays.first(originWorld, direction);
    if (!hit || !hit->back) continue;
    near.push_back(hit->distance);
    const double skin = 1e-5 * glm::length(rays.bounds().size());
    const std::optional<SurfaceHit> next = rays.first(originWorld + (hit->distance + skin) * direction, direction);
    if (!next) continue;
    beyond.push_back(next->distance);
    fronts += next->back ? 0.0 : 1.0;
  }
  if (near.size() < kLooks / 2 || beyond.empty() || fronts < 0.3 * static_cast<double>(near.size())) return false;
  return medianOf(near) < 0.75 * medianOf(beyond);
}

}  // namespace boxprobe
