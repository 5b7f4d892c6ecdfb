// See fit_light_errors.h.
#include "app/session/fit_light_errors.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <vector>

#include "app/session/load_scene.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/box_gauge.h"
#include "filters/reference/path/reference_path.h"

namespace boxprobe {

namespace {

constexpr std::size_t kRays = 1024;
constexpr int kPaths = 64;      // of each ray
constexpr double kWhite = 5.0;  // over the mean
constexpr std::uint64_t kSeeds[2] = {1, 2};

using Estimates = std::array<std::vector<glm::dvec3>, 2>;  ///< two estimates that share no path

/// Just before the surface that the origin sees there, so that what probes do not see hides nothing.
PathRay seenFrom(const FitPlace& place, const glm::dvec3& origin, const glm::dvec3& along, std::size_t stream) {
  const std::optional<SurfaceHit> hit = place.captured.first(origin, along);
  return {hit ? origin + (1.0 - 1e-3) * hit->distance * along : origin, along, static_cast<std::uint32_t>(stream)};
}

/// What is looked up for each ray, along the axes of the probe's box; `lookups` are along the world's.
std::vector<PathRay> lookedUp(const FitPlace& place, const LookupRays& lookups, const Probe& probe) {
  const glm::dmat3 worldFromBox = rotationMatrix(probe.rotationDegrees);
  const glm::dmat3 boxFromWorld = glm::transpose(worldFromBox);
  const OffsetBox box = offsetBox(probe);
  std::vector<PathRay> rays;
  for (const LookupRay& ray : lookups.rays) {
    LookupRay turned;
    turned.from = boxFromWorld * ray.from;
    turned.along = boxFromWorld * ray.along;
    const glm::dvec3 sampled = turned.from + boxExit(turned, box.offset).distance * turned.along;
    const double length = glm::length(sampled);
    const glm::dvec3 direction = length > 0.0 ? worldFromBox * (sampled / length) : ray.along;
    rays.push_back(seenFrom(place, probe.origin, direction, ray.reflected));
  }
  return rays;
}

std::vector<PathRay> right(const FitPlace& place, const LookupRays& lookups, const glm::dvec3& origin) {
  std::vector<PathRay> rays;
  for (const LookupRay& ray : lookups.rays) rays.push_back(seenFrom(place, origin, ray.target, ray.reflected));
  return rays;
}

glm::dvec3 clamped(const glm::dvec3& light, double white) {
  return glm::clamp(light, glm::dvec3(0.0), glm::dvec3(white));
}

/// Relative error of what is looked up. Of two estimates without a path in common the product has no noise on the mean.
double errorOf(const LookupRays& lookups, const Estimates& truth, const Estimates& lookedUp) {
  double sum = 0.0;
  for (std::size_t i = 0; i < lookups.rays.size(); ++i) {
    const glm::dvec3 light = 0.5 * (truth[0][i] + truth[1][i]);
    sum += lookups.rays[i].weight * (light.x + light.y + light.z) / 3.0;
  }
  const double white = kWhite * sum;  // the weights' sum is 1
  double off = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < lookups.rays.size(); ++i) {
    const double weight = lookups.rays[i].weight;
    const glm::dvec3 a = clamped(truth[0][i], white), b = clamped(truth[1][i], white);
    off += weight * glm::dot(clamped(lookedUp[0][i], white) - a, clamped(lookedUp[1][i], white) - b);
    whole += weight * glm::dot(a, b);
  }
  return whole > 0.0 ? std::sqrt(std::max(off, 0.0) / whole) : 0.0;
}

bool dark(const Estimates& light) {
  const auto none = [](const glm::dvec3& each) { return each == glm::dvec3(0.0); };
  return std::all_of(light[0].begin(), light[0].end(), none) && std::all_of(light[1].begin(), light[1].end(), none);
}

}  // namespace

std::optional<FitLightErrors> fitLightErrors(const Scene& scene, const TriangleRays::Models& models,
                                             ProbeFitter& fitter, const Probe& before, const BoxFit& fit,
                                             const FitProgress& progress) {
  const FitPlace place = fitter.placeOf(before);
  const ReflectedRays reflected = reflectedRays(place, before, kBoxRays);
  const glm::dmat3 alongWorld(1.0);
  const LookupRays old = someOf(lookupRays(place, reflected, before.origin, alongWorld), kRays);
  const bool still = fit.probe.origin == before.origin;
  const LookupRays now = still ? old : someOf(lookupRays(place, reflected, fit.probe.origin, alongWorld), kRays);
  if (old.rays.empty() || now.rays.empty()) return std::nullopt;
  const ReferencePath path(scene, models, loadSkyImage(scene));

  enum Asked : std::size_t { OldTruth, Before, Truth, After, FirstFace };
  std::vector<std::vector<PathRay>> asked = {right(place, old, before.origin), lookedUp(place, old, before),
                                             right(place, now, fit.probe.origin), lookedUp(place, now, fit.probe)};
  const OffsetBox was = offsetBox(before);
  for (int face = 0; face < kFaces && still; ++face) {
    asked.push_back(lookedUp(place, now, withFaceAt(fit.probe, face, was.offset[static_cast<std::size_t>(face)])));
  }
  // Most rays are asked for more than once: each is traced once.
  std::vector<PathRay> rays;
  std::vector<std::vector<std::size_t>> at(asked.size());
  std::map<std::array<double, 7>, std::size_t> known;
  for (std::size_t which = 0; which < asked.size(); ++which) {
    for (const PathRay& ray : asked[which]) {
      const auto [found, added] = known.try_emplace(
          {ray.from.x, ray.from.y, ray.from.z, ray.along.x, ray.along.y, ray.along.z, static_cast<double>(ray.stream)},
          rays.size());
      if (added) rays.push_back(ray);
      at[which].push_back(found->second);
    }
  }
  Estimates light;
  for (std::size_t half = 0; half < light.size(); ++half) {
    light[half] = path.radianceAlong(rays, kPaths / 2, kSeeds[half], [&](double done) {
      return !progress || progress(0.5 * (static_cast<double>(half) + done));
    });
    if (light[half].empty()) return std::nullopt;
  }
  const auto of = [&](std::size_t which) {
    Estimates part;
    for (std::size_t half = 0; half < part.size(); ++half) {
      for (const std::size_t i : at[which]) part[half].push_back(light[half][i]);
    }
    return part;
  };
  if (dark(light)) return std::nullopt;
  FitLightErrors errors;
  errors.before = errorOf(old, of(OldTruth), of(Before));
  errors.after = errorOf(now, of(Truth), of(After));
  for (std::size_t face = 0; FirstFace + face < asked.size(); ++face) {
    errors.faceGain[face] = errorOf(now, of(Truth), of(FirstFace + face)) - errors.after;
  }
  return errors;
}

}  // namespace boxprobe
