// See face_planes.h.
#include "filters/fit/box/face_planes.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "filters/fit/box/axis_turn.h"

namespace boxprobe {

std::vector<MetPoint> metPoints(const FitPlace& place, const ReflectedRays& reflected, const glm::dvec3& originWorld,
                                const glm::dmat3& worldFromBox) {
  constexpr int kAround = 2048;
  const glm::dmat3 boxFromWorld = glm::transpose(worldFromBox);
  std::vector<MetPoint> points;
  for (const glm::dvec3& direction : fibonacciDirections(kAround)) {
    const std::optional<SurfaceHit> hit = place.captured.first(originWorld, direction);
    if (!hit) continue;
    points.push_back({boxFromWorld * (hit->distance * direction), boxFromWorld * hit->normalWorld, 0.5 / kAround});
  }
  for (const ReflectedRay& ray : reflected.rays) {
    points.push_back({boxFromWorld * (ray.hit - originWorld), boxFromWorld * ray.hitNormal, 0.5 * ray.weight});
  }
  return points;
}

std::vector<MetPoint> turnedBy(const std::vector<MetPoint>& points, double yaw) {
  const AxisTurn turn(yaw);
  std::vector<MetPoint> turned;
  turned.reserve(points.size());
  for (const MetPoint& point : points) turned.push_back({turn(point.position), turn(point.normal), point.weight});
  return turned;
}

UprightYaw uprightYaw(const std::vector<MetPoint>& points) {
  constexpr double kUpright = 0.2;
  std::complex<double> sum(0.0);
  double all = 0.0;
  for (const MetPoint& point : points) {
    const double level = std::hypot(point.normal.x, point.normal.z);
    if (std::abs(point.normal.y) > kUpright || !(level > 0.0)) continue;
    const std::complex<double> n(point.normal.x / level, point.normal.z / level);
    sum += point.weight * n * n * n * n;
    all += point.weight;
  }
  if (!(all > 0.0)) return {};
  // A rotation by yaw about +y takes +x to (cos, 0, -sin).
  return {-0.25 * std::arg(sum), std::abs(sum) / all};
}

namespace {

struct Weighed {
  double value = 0.0, weight = 0.0;
};

/// The value below which a share of the weight lies; sorts.
double quantileOf(std::vector<Weighed>& values, double share) {
  std::sort(values.begin(), values.end(), [](const Weighed& a, const Weighed& b) { return a.value < b.value; });
  double all = 0.0, sum = 0.0;
  for (const Weighed& each : values) all += each.weight;
  for (const Weighed& each : values) {
    sum += each.weight;
    if (sum >= share * all) return each.value;
  }
  return 0.0;
}

/// The highest peaks of a histogram, each at the median of the values around it.
std::vector<double> peaksOf(const std::vector<Weighed>& values, double reach) {
  constexpr std::size_t kBins = 96, kPeaks = 4;
  std::array<double, kBins + 2> bins{};
  const double width = reach / static_cast<double>(kBins);
  for (const Weighed& each : values) {
    const auto bin = static_cast<std::size_t>(std::clamp(each.value / width, 0.0, static_cast<double>(kBins) - 0.5));
    bins[bin + 1] += each.weight;
  }
  std::vector<std::pair<double, double>> peaks;  // height, middle
  for (std::size_t i = 1; i <= kBins; ++i) {
    const auto smooth = [&](std::size_t k) {
      return bins[k] + 0.5 * (k > 0 ? bins[k - 1] : 0.0) + 0.5 * (k + 1 < bins.size() ? bins[k + 1] : 0.0);
    };
    const double here = smooth(i);
    if (here > 0.0 && here >= smooth(i - 1) && here > smooth(i + 1)) {
      peaks.emplace_back(here, (static_cast<double>(i) - 0.5) * width);
    }
  }
  std::sort(peaks.rbegin(), peaks.rend());
  if (peaks.size() > kPeaks) peaks.resize(kPeaks);
  std::vector<double> found;
  for (const auto& [height, middle] : peaks) {
    std::vector<Weighed> about;
    for (const Weighed& each : values) {
      if (std::abs(each.value - middle) <= 1.5 * width) about.push_back(each);
    }
    found.push_back(quantileOf(about, 0.5));
  }
  return found;
}

}  // namespace

FacePlanes facePlanes(const std::vector<MetPoint>& points) {
  constexpr double kFacing = 0.8;
  FacePlanes planes;
  for (int face = 0; face < kFaces; ++face) {
    const int axis = face / 2;
    const double side = face % 2 == 0 ? -1.0 : 1.0;
    std::vector<Weighed> all, facing, beside;
    for (const MetPoint& point : points) {
      const double value = side * point.position[axis], slope = side * point.normal[axis];
      if (value <= 0.0) continue;
      all.push_back({value, point.weight});
      if (slope < -kFacing) facing.push_back({value, point.weight});
      if (std::abs(slope) < 0.2) beside.push_back({value, point.weight});
    }
    const auto index = static_cast<std::size_t>(face);
    std::vector<double>& offsets = planes.offsets[index];
    const double reach = quantileOf(all, 0.98);
    if (!(reach > 0.0)) continue;
    offsets = peaksOf(facing, 1.02 * reach);
    planes.likeliest[index] = offsets.empty() ? reach : offsets.front();
    offsets.push_back(reach);
    if (!beside.empty()) offsets.push_back(quantileOf(beside, 0.95));
    std::sort(offsets.begin(), offsets.end());
    const auto near = [reach](double a, double b) { return b - a < 0.004 * reach; };
    offsets.erase(std::unique(offsets.begin(), offsets.end(), near), offsets.end());
  }
  return planes;
}

}  // namespace boxprobe
