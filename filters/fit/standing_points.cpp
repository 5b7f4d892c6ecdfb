// See standing_points.h.
#include "filters/fit/standing_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

constexpr double kEyeHeight = 1.6;     // metres
constexpr double kTallestRoom = 60.0;  // metres: a higher room is in another unit

/// In scene units. For a room above 60 m, in the unit that makes it 2 to 8 m high, if there is one.
double eyeHeight(double height) {
  const double most = 0.6 * height;
  if (height <= kTallestRoom) return std::clamp(kEyeHeight, 0.25 * height, most);
  for (const double unitsPerMetre : {100.0, 1000.0}) {
    if (height >= 2.0 * unitsPerMetre && height <= 8.0 * unitsPerMetre) {
      return std::min(kEyeHeight * unitsPerMetre, most);
    }
  }
  return most;
}

/// At eye height above the floor below `from`; as a share of the room's height if the file cannot be in metres.
std::optional<StandingPoint> standingBelow(const TriangleRays& rays, const glm::dvec3& from) {
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const std::optional<SurfaceHit> below = rays.first(from, -up);
  if (!below || below->back || below->normalWorld.y < 0.5) return std::nullopt;
  const std::optional<SurfaceHit> above = rays.first(from, up);
  StandingPoint point;
  point.floor = from.y - below->distance;
  const double ceiling = above ? from.y + above->distance : std::max(rays.core().max.y, from.y);
  point.height = ceiling - point.floor;
  point.eyeWorld = {from.x, point.floor + eyeHeight(point.height), from.z};
  return point;
}

/// Distance to the nearest surface at eye level and above; nothing inside or behind a surface.
std::optional<double> clearanceAt(const TriangleRays& rays, const glm::dvec3& eye) {
  constexpr int kRays = 96;
  double nearest = glm::length(rays.bounds().size());
  int backs = 0;
  for (const glm::dvec3& direction : fibonacciDirections(kRays)) {
    const std::optional<SurfaceHit> hit = rays.first(eye, direction);
    backs += hit && hit->back ? 1 : 0;
    if (hit && direction.y > -0.5) nearest = std::min(nearest, hit->distance);
  }
  return backs > kRays / 3 ? std::nullopt : std::optional(nearest);
}

double medianOf(const std::vector<StandingPoint>& points, double StandingPoint::*member) {
  std::vector<double> values;
  for (const StandingPoint& point : points) values.push_back(point.*member);
  const auto median = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), median, values.end());
  return *median;
}

/// The floor that most points stand on: the median one, unless another has more. Of two storeys the median may be a
/// step of the stairs between them.
double commonFloor(const std::vector<StandingPoint>& points) {
  const auto standingWith = [&](const StandingPoint& at) {
    return std::count_if(points.begin(), points.end(), [&at](const StandingPoint& point) {
      return std::abs(point.floor - at.floor) <= 0.1 * std::min(point.height, at.height);
    });
  };
  const double median = medianOf(points, &StandingPoint::floor);
  const auto isMedian = [median](const StandingPoint& point) { return point.floor == median; };
  auto common = std::find_if(points.begin(), points.end(), isMedian);
  auto most = standingWith(*common);
  for (auto point = points.begin(); point != points.end(); ++point) {
    const auto here = standingWith(*point);
    if (here > most) common = point, most = here;
  }
  return common->floor;
}

/// Keeps the points on the most common floor below its most common ceiling: others are on or under tables, or in
/// another storey.
void leaveFurniture(std::vector<StandingPoint>& points) {
  const double floor = commonFloor(points);
  const auto elsewhere = [floor](const StandingPoint& point) {
    return std::abs(point.floor - floor) > 0.1 * point.height;
  };
  points.erase(std::remove_if(points.begin(), points.end(), elsewhere), points.end());
  const double height = medianOf(points, &StandingPoint::height);
  const auto low = [height](const StandingPoint& point) { return point.height < 0.6 * height; };
  points.erase(std::remove_if(points.begin(), points.end(), low), points.end());
}

}  // namespace

std::vector<StandingPoint> standingPoints(const TriangleRays& rays, const ModelSurvey& survey) {
  std::vector<StandingPoint> points;
  for (const SurveyedPoint& surveyed : survey.points) {
    if (!(surveyed.enclosed() || (survey.kind != ModelKind::Interior && surveyed.walled()))) continue;
    std::optional<StandingPoint> point = standingBelow(rays, surveyed.positionWorld);
    if (!point) continue;
    const std::optional<double> clearance = clearanceAt(rays, point->eyeWorld);
    if (!clearance) continue;
    point->clearance = *clearance;
    points.push_back(*point);
  }
  if (points.empty()) return points;
  leaveFurniture(points);
  glm::dvec3 sum(0.0);
  for (const StandingPoint& point : points) sum += point.eyeWorld;
  const glm::dvec3 middle = sum / static_cast<double>(points.size());
  const double reach = 0.5 * glm::length(rays.core().size());
  const auto worth = [&](const StandingPoint& point) {
    return std::min(2.0 * point.clearance / point.height, 1.0) - glm::length(point.eyeWorld - middle) / reach;
  };
  std::stable_sort(points.begin(), points.end(),
                   [&](const StandingPoint& a, const StandingPoint& b) { return worth(a) > worth(b); });
  return points;
}

}  // namespace boxprobe
