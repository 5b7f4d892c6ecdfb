// See lookup_rays.h.
#include "filters/fit/box/lookup_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "filters/fit/box/axis_turn.h"
#include "filters/fit/box/visibility.h"

namespace boxprobe {

const char* faceName(int face) {
  static constexpr const char* kNames[kFaces] = {"-x", "+x", "-y", "+y", "-z", "+z"};
  return kNames[face];
}

LookupRays lookupRays(const FitPlace& place, const ReflectedRays& reflected, const glm::dvec3& originWorld,
                      const glm::dmat3& worldFromBox) {
  const glm::dmat3 boxFromWorld = glm::transpose(worldFromBox);
  LookupRays lookups;
  double seen = 0.0, all = 0.0;
  for (std::size_t i = 0; i < reflected.rays.size(); ++i) {
    const ReflectedRay& ray = reflected.rays[i];
    all += ray.weight;
    const glm::dvec3 target = ray.hit - originWorld;
    const double distance = glm::length(target);
    if (!(distance > 0.0) || !visibleFrom(place.captured, originWorld, ray.hit)) continue;
    seen += ray.weight;
    lookups.rays.push_back({boxFromWorld * (ray.from - originWorld), boxFromWorld * ray.along,
                            boxFromWorld * (target / distance), ray.weight, i});
  }
  for (LookupRay& ray : lookups.rays) ray.weight /= seen;
  lookups.hidden = all > 0.0 ? 1.0 - seen / all : 0.0;
  return lookups;
}

namespace {

LookupRay turnedRay(const LookupRay& ray, const AxisTurn& turn) {
  return {turn(ray.from), turn(ray.along), turn(ray.target), ray.weight, ray.reflected};
}

}  // namespace

LookupRays turnedBy(const LookupRays& rays, double yaw) {
  const AxisTurn turn(yaw);
  LookupRays turned{{}, rays.hidden};
  turned.rays.reserve(rays.rays.size());
  for (const LookupRay& ray : rays.rays) turned.rays.push_back(turnedRay(ray, turn));
  return turned;
}

LookupRays someOf(const LookupRays& rays, std::size_t count) {
  if (rays.rays.size() <= count) return rays;
  LookupRays some{{}, rays.hidden};
  const double step = static_cast<double>(rays.rays.size()) / static_cast<double>(count);
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    some.rays.push_back(rays.rays[static_cast<std::size_t>(step * (static_cast<double>(i) + 0.5))]);
    sum += some.rays.back().weight;
  }
  for (LookupRay& ray : some.rays) ray.weight /= sum;
  return some;
}

BoxExit boxExit(const LookupRay& ray, const std::array<double, kFaces>& offset) {
  BoxExit exit{3.0e38, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const double speed = ray.along[axis];
    const int face = 2 * axis + (speed < 0.0 ? 0 : 1);
    const double gap =
        std::max(offset[static_cast<std::size_t>(face)] - (speed < 0.0 ? -1.0 : 1.0) * ray.from[axis], 0.0);
    const double size = std::abs(speed);
    if (size * exit.distance > gap) exit = {gap / size, face};
  }
  return exit;
}

double lookupError(const LookupRay& ray, double distance) {
  const glm::dvec3 d = ray.from + distance * ray.along;
  const double length = glm::length(d);
  if (!(length > 0.0)) return 0.0;
  return std::acos(std::clamp(glm::dot(d, ray.target) / length, -1.0, 1.0));
}

double meanError(const LookupRays& rays, const OffsetBox& box) {
  const AxisTurn turn(box.yaw);
  double sum = 0.0;
  for (const LookupRay& each : rays.rays) {
    const LookupRay ray = box.yaw == 0.0 ? each : turnedRay(each, turn);
    sum += ray.weight * lookupError(ray, boxExit(ray, box.offset).distance);
  }
  return glm::degrees(sum);
}

LookupErrors lookupErrors(const LookupRays& rays, const OffsetBox& box) {
  const LookupRays turned = turnedBy(rays, box.yaw);
  LookupErrors errors;
  std::vector<std::pair<double, double>> sorted;
  for (const LookupRay& ray : turned.rays) {
    const double degrees = glm::degrees(lookupError(ray, boxExit(ray, box.offset).distance));
    errors.meanDegrees += ray.weight * degrees;
    if (degrees > 5.0) errors.above5 += ray.weight;
    sorted.emplace_back(degrees, ray.weight);
  }
  std::sort(sorted.begin(), sorted.end());
  double below = 0.0;
  for (const auto& [degrees, weight] : sorted) {
    below += weight;
    errors.p95Degrees = degrees;
    if (below >= 0.95) break;
  }
  return errors;
}

std::array<double, kFaces> faceSensitivities(const LookupRays& rays, const OffsetBox& box) {
  constexpr double kLeastSlope = 0.05;  // bounds the contribution of rays along the wall
  std::array<double, kFaces> sensitivities{};
  for (const LookupRay& ray : turnedBy(rays, box.yaw).rays) {
    const BoxExit exit = boxExit(ray, box.offset);
    const glm::dvec3 d = ray.from + exit.distance * ray.along;
    const double length = glm::length(d);
    if (!(length > 0.0)) continue;
    const double slope = std::max(std::abs(ray.along[exit.face / 2]), kLeastSlope);
    const double sine = glm::length(glm::cross(ray.along, d)) / length;
    sensitivities[static_cast<std::size_t>(exit.face)] += glm::degrees(ray.weight * sine / (length * slope));
  }
  return sensitivities;
}

}  // namespace boxprobe
