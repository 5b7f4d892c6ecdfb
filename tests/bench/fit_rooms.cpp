// The fit among its rivals in random rooms: `fit_rooms [tune|judge] [COUNT] [FIRST] [--plans DIR]`. Rooms from seed
// 1000 on (tune) were looked at while the fit was made, those from 5000 on (judge) never. A row a room: mean lookup
// error in degrees on rays that no method was fitted with, and that over the best found by brute force on those very
// rays. At the end the worst rooms; with --plans each as a drawing with the fitted box (orange) and the best one
// (green).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/fit_box.h"
#include "filters/fit/rays/triangle_rays.h"
#include "filters/io/image/image_file.h"
#include "tests/bench/room_plan.h"
#include "tests/support/random_room.h"

namespace boxprobe {
namespace {

constexpr double kSmall = 0.035;  // degrees: a tenth of a texel of 256² faces; two boxes within it are equally good

/// The range in which brute force looks: how far 98 % of what the origin sees reaches, for each face.
std::array<double, kFaces> reachOf(const std::vector<MetPoint>& points) {
  std::array<double, kFaces> reach{};
  for (int face = 0; face < kFaces; ++face) {
    std::vector<double> values;
    for (const MetPoint& point : points) {
      const double value = (face % 2 == 0 ? -1.0 : 1.0) * point.position[face / 2];
      if (value > 0.0) values.push_back(value);
    }
    std::sort(values.begin(), values.end());
    reach[static_cast<std::size_t>(face)] =
        values.empty() ? 1.0 : values[static_cast<std::size_t>(0.98 * static_cast<double>(values.size() - 1))];
  }
  return reach;
}

/// 9 offsets for each face times 7 yaws, the 50 best polished.
RatedBox bruteForce(const LookupRays& rays, const std::vector<MetPoint>& points, double roomYaw) {
  const LookupRays few = someOf(rays, 384), some = someOf(rays, 1024);
  std::vector<RatedBox> found;
  for (const double degrees : {-30.0, -12.0, -4.0, 0.0, 4.0, 12.0, 30.0}) {
    const double yaw = roomYaw + glm::radians(degrees);
    const std::array<double, kFaces> reach = reachOf(turnedBy(points, yaw));
    std::array<std::vector<double>, kFaces> offsets;
    for (std::size_t face = 0; face < kFaces; ++face) {
      for (int i = 0; i < 9; ++i) offsets[face].push_back(reach[face] * (0.3 + 0.1 * i));
    }
    const std::vector<RatedBox> best = bestCombinations(turnedBy(few, yaw), offsets, 50, yaw);
    found.insert(found.end(), best.begin(), best.end());
  }
  const auto better = [](const RatedBox& a, const RatedBox& b) { return a.meanDegrees < b.meanDegrees; };
  std::stable_sort(found.begin(), found.end(), better);
  found.resize(50);
  PolishSettings settings;
  settings.lastStep = 0.004;
  settings.nearest = 1e-3;
  for (RatedBox& each : found) each = polished(some, each.box, settings);
  std::stable_sort(found.begin(), found.end(), better);
  found.resize(5);
  settings.lastStep = 0.0002;
  settings.firstStep = 0.02;
  for (RatedBox& each : found) each = polished(rays, each.box, settings);
  return *std::min_element(found.begin(), found.end(), better);
}

OffsetBox fromBox(const Probe& probe, const Box& box) {
  Probe with = probe;
  with.box = box;
  return offsetBox(with);
}

OffsetBox sixRays(const SurfaceRays& rays, const Probe& probe) {
  OffsetBox box;
  for (int face = 0; face < kFaces; ++face) {
    glm::dvec3 direction(0.0);
    direction[face / 2] = face % 2 == 0 ? -1.0 : 1.0;
    const std::optional<SurfaceHit> hit = rays.first(probe.origin, direction);
    const Box& bounds = rays.bounds();
    const double edge =
        face % 2 == 0 ? probe.origin[face / 2] - bounds.min[face / 2] : bounds.max[face / 2] - probe.origin[face / 2];
    box.offset[static_cast<std::size_t>(face)] = hit ? hit->distance : edge;
  }
  return box;
}

OffsetBox quantiles(const SurfaceRays& rays, const Probe& probe) {
  std::array<std::vector<double>, 3> values;
  for (const glm::dvec3& direction : fibonacciDirections(4096)) {
    const std::optional<SurfaceHit> hit = rays.first(probe.origin, direction);
    for (int axis = 0; hit && axis < 3; ++axis) {
      values[static_cast<std::size_t>(axis)].push_back(hit->distance * direction[axis]);
    }
  }
  OffsetBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double>& v = values[axis];
    std::sort(v.begin(), v.end());
    box.offset[2 * axis] = std::max(0.0, -v[static_cast<std::size_t>(0.02 * static_cast<double>(v.size()))]);
    box.offset[2 * axis + 1] = std::max(0.0, v[static_cast<std::size_t>(0.98 * static_cast<double>(v.size()))]);
  }
  return box;
}

/// The highest bin of each side, of what the origin sees all around.
OffsetBox histogram(const FitPlace& place, const Probe& probe) {
  const FacePlanes planes = facePlanes(metPoints(place, {}, probe.origin, glm::dmat3(1.0)));
  OffsetBox box;
  box.offset = planes.likeliest;
  return box;
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

struct Judged {
  std::uint32_t seed = 0;
  test::RandomRoom room;
  Probe ours, best;
  double error = 0.0, least = 0.0, ratio = 0.0;
};

/// The eight of the largest ratio, worst first.
int tellWorst(std::vector<Judged> judged, const std::string& folder) {
  constexpr std::size_t kWorst = 8;
  std::stable_sort(judged.begin(), judged.end(), [](const Judged& a, const Judged& b) { return a.ratio > b.ratio; });
  judged.resize(std::min(judged.size(), kWorst));
  std::printf("\nworst rooms\n");
  for (const Judged& each : judged) {
    const std::string path = folder + "/" + std::to_string(each.seed) + ".png";
    std::printf("%-5u %-40s %.3f degrees, best %.3f: %.3f times%s\n", each.seed, each.room.what.c_str(), each.error,
                each.least, each.ratio, folder.empty() ? "" : (", " + path).c_str());
    if (folder.empty()) continue;
    try {
      std::filesystem::create_directories(folder);
      savePng(path, bench::roomPlan(each.room, {{each.best, {0, 150, 60}}, {each.ours, {235, 120, 0}}}));
    } catch (const std::exception& error) {
      std::fprintf(stderr, "fit_rooms: --plans %s: %s\n", folder.c_str(), error.what());
      return 2;
    }
  }
  return 0;
}

int run(std::vector<std::string> words) {
  std::string folder;
  if (const auto flag = std::find(words.begin(), words.end(), "--plans"); flag != words.end()) {
    if (flag + 1 == words.end()) {
      std::fprintf(stderr, "fit_rooms: --plans needs a folder for the drawings\n");
      return 2;
    }
    folder = *(flag + 1);
    words.erase(flag, flag + 2);
  }
  const std::size_t argc = words.size() + 1;
  const std::string set = argc > 1 ? words[0] : "tune";
  const int count = argc > 2 ? std::atoi(words[1].c_str()) : 64;
  const std::uint32_t first =
      (set == "judge" ? 5000u : 1000u) + static_cast<std::uint32_t>(argc > 3 ? std::atoi(words[2].c_str()) : 0);
  const bool brute = argc <= 4;
  static const char* kNames[] = {"ours", "bounds", "six rays", "2-98 %", "histogram"};
  std::vector<double> ratios[5], seconds, errors[6];
  std::vector<Judged> judged;
  std::printf("%-5s %-36s %7s %7s %7s %7s %7s %7s %7s %7s %6s\n", "seed", "room", "best", "ours", "bounds", "six",
              "2-98%", "hist", "ratio", "p95", "s");
  for (int i = 0; i < count; ++i) {
    const test::RandomRoom room = test::randomRoom(first + static_cast<std::uint32_t>(i));
    const TriangleRays rays(room.scene, {room.model});
    const FitPlace place{rays, rays, room.scene.cameras};
    const Probe& probe = room.scene.probes.front();
    const auto begun = std::chrono::steady_clock::now();
    const std::optional<BoxFit> fit = fitBox(place, probe);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());

    const ReflectedRays reflected = reflectedRays(place, probe, 4096, 0.5);
    const LookupRays judge = lookupRays(place, reflected, probe.origin, glm::dmat3(1.0));
    const auto errorOf = [&](const OffsetBox& box) { return lookupErrors(judge, box).meanDegrees; };
    OffsetBox ours = offsetBox(fit->probe);
    ours.yaw = glm::radians(fit->probe.rotationDegrees.y);
    const double measured[5] = {errorOf(ours), errorOf(fromBox(probe, rays.bounds())), errorOf(sixRays(rays, probe)),
                                errorOf(quantiles(rays, probe)), errorOf(histogram(place, probe))};
    const std::vector<MetPoint> points = metPoints(place, reflected, probe.origin, glm::dmat3(1.0));
    RatedBox rated{ours, 1.0};
    if (brute) rated = bruteForce(judge, points, glm::radians(room.yawDegrees));
    const double best = rated.meanDegrees;
    for (int k = 0; k < 5; ++k) {
      ratios[k].push_back(std::max(measured[k], kSmall) / std::max(best, kSmall));
      errors[k].push_back(measured[k]);
    }
    errors[5].push_back(best);
    judged.push_back({first + static_cast<std::uint32_t>(i), room, fit->probe,
                      withOffsetBox(probe, rated.box, glm::dvec3(0.0)), measured[0], best, ratios[0].back()});
    std::printf("%-5u %-36s %7.3f %7.3f %7.3f %7.3f %7.3f %7.3f %7.3f %7.2f %6.2f\n",
                first + static_cast<std::uint32_t>(i), room.what.c_str(), best, measured[0], measured[1], measured[2],
                measured[3], measured[4], ratios[0].back(), lookupErrors(judge, ours).p95Degrees, seconds.back());
    std::fflush(stdout);
  }
  std::printf("\n%-12s %10s %10s %12s %12s %12s\n", "", "error", "", "over best", "", "");
  std::printf("%-12s %10s %10s %12s %12s %12s\n", "", "median", "90 %", "median", "90 %", "worst");
  for (int k = 0; k < 5; ++k) {
    std::printf("%-12s %10.3f %10.3f %12.3f %12.3f %12.3f\n", kNames[k], percentile(errors[k], 0.5),
                percentile(errors[k], 0.9), percentile(ratios[k], 0.5), percentile(ratios[k], 0.9),
                percentile(ratios[k], 1.0));
  }
  std::printf("%-12s %10.3f %10.3f\n", "brute force", percentile(errors[5], 0.5), percentile(errors[5], 0.9));
  std::printf("seconds of the fit: median %.2f, most %.2f\n", percentile(seconds, 0.5), percentile(seconds, 1.0));
  return brute ? tellWorst(std::move(judged), folder) : 0;
}

}  // namespace
}  // namespace boxprobe

int main(int argc, char** argv) {
  return boxprobe::run(std::vector<std::string>(argv + 1, argv + argc));
}
