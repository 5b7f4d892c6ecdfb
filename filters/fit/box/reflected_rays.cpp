// See reflected_rays.h.
#include "filters/fit/box/reflected_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/visibility.h"
#include "filters/math/sampling/van_der_corput.h"

namespace boxprobe {

namespace {

constexpr double kEvenShare = 0.2;
constexpr double kAspect = 16.0 / 9.0;

/// Does a surface point get its reflections from the probe?
class Lit {
 public:
  Lit(const FitPlace& place, const Probe& probe)
      : place_(place), probe_(probe), boxFromWorld_(glm::transpose(rotationMatrix(probe.rotationDegrees))) {}
  bool operator()(const glm::dvec3& position) const {
    if (!probe_.influence) return visibleFrom(place_.captured, probe_.origin, position);
    const glm::dvec3 pivot = probe_.box.center(), p = pivot + boxFromWorld_ * (position - pivot);
    return glm::all(glm::greaterThanEqual(p, probe_.influence->min)) &&
           glm::all(glm::lessThanEqual(p, probe_.influence->max));
  }

 private:
  const FitPlace& place_;
  const Probe& probe_;
  glm::dmat3 boxFromWorld_;
};

struct EyeRay {
  glm::dvec3 from, along;
};

EyeRay cameraRay(const Camera& camera, double u, double v) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  const double x = 2.0 * u - 1.0, y = 2.0 * v - 1.0;
  if (camera.parallelHeight > 0.0) {
    const double half = 0.5 * camera.parallelHeight;
    return {camera.position + right * (x * half * kAspect) + up * (y * half), forward};
  }
  const double half = std::tan(0.5 * glm::radians(camera.verticalFovDegrees));
  return {camera.position, glm::normalize(forward + right * (x * half * kAspect) + up * (y * half))};
}

/// Eyes of standing people that the probe's origin sees, 1.2 to 1.8 m above the floor.
std::vector<glm::dvec3> standingEyes(const FitPlace& place, const Probe& probe) {
  constexpr int kTries = 64, kEyes = 16;
  std::vector<glm::dvec3> eyes;
  const Lit lit(place, probe);
  for (int i = 1; i <= kTries && eyes.size() < kEyes; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * vanDerCorput(i, 2);
    const glm::dvec3 level(std::cos(angle), 0.0, std::sin(angle));
    const std::optional<SurfaceHit> wall = place.captured.first(probe.origin, level);
    if (!wall) continue;
    const glm::dvec3 stand = probe.origin + level * (wall->distance * 0.9 * std::sqrt(vanDerCorput(i, 3)));
    const std::optional<SurfaceHit> floor = place.captured.first(stand, {0.0, -1.0, 0.0});
    if (!floor) continue;
    const double height = std::max(floor->distance, 1.2 + 0.6 * vanDerCorput(i, 5));
    const glm::dvec3 eye = stand + glm::dvec3(0.0, std::min(height, 1.8) - floor->distance, 0.0);
    if (lit(eye)) eyes.push_back(eye);
  }
  if (eyes.empty()) eyes.push_back(probe.origin);
  return eyes;
}

/// Schlick's approximation.
double fresnel(double reflectance, double cosine) {
  return reflectance + (1.0 - reflectance) * std::pow(1.0 - cosine, 5.0);
}

/// How clearly a reflection can be located on a surface of that roughness.
double gloss(double roughness) {
  return std::clamp((0.6 - roughness) / 0.2, 0.0, 1.0);
}

/// Collects rays and their weights; rays to the sky separately.
class Collector {
 public:
  explicit Collector(const FitPlace& place)
      : place_(&place), skin_(1e-5 * glm::length(place.captured.bounds().size())) {}

  /// `ray` has everything except its end.
  void follow(ReflectedRay ray) {
    const glm::dvec3 from = ray.from + skin_ * ray.fromNormal;
    const std::optional<SurfaceHit> hit = place_->captured.first(from, ray.along);
    (hit ? met_ : open_) += ray.weight;
    if (!hit) return;
    ray.hit = from + hit->distance * ray.along;
    ray.hitNormal = hit->normalWorld;
    rays_.push_back(ray);
  }
  /// Scales the weights such that those of rays with a hit sum to `share`.
  void moveTo(ReflectedRays& all, double share) {
    for (ReflectedRay& ray : rays_) {
      ray.weight *= share / met_;
      all.rays.push_back(ray);
    }
    if (met_ + open_ > 0.0) all.open += share * open_ / (met_ + open_);
  }
  bool empty() const { return !(met_ > 0.0); }
  std::size_t size() const { return rays_.size(); }

 private:
  const FitPlace* place_;
  double skin_, met_ = 0.0, open_ = 0.0;
  std::vector<ReflectedRay> rays_;
};

/// Seen by the cameras, or by people standing around. `rough`: all surfaces reflect.
Collector seenReflections(const FitPlace& place, const Probe& probe, int count, int first, bool standing, bool rough) {
  const Lit lit(place, probe);
  std::vector<glm::dvec3> eyes;
  if (standing) eyes = standingEyes(place, probe);
  Collector collected(place);
  const int tries = 6 * count;
  for (int i = 1; i <= tries && static_cast<int>(collected.size()) < count; ++i) {
    const int index = first + i;
    const double u = vanDerCorput(index, 2), v = vanDerCorput(index, 3);
    EyeRay eye;
    if (standing) {
      eye = {eyes[static_cast<std::size_t>(index) % eyes.size()], sphereDirection(u, v)};
    } else {
      eye = cameraRay(place.eyes[static_cast<std::size_t>(index) % place.eyes.size()], u, v);
    }
    const std::optional<SurfaceHit> hit = place.shown.first(eye.from, eye.along);
    if (!hit) continue;
    const double shine = rough ? 1.05 - std::min(hit->roughness, 1.0) : gloss(hit->roughness);
    const double weight = shine * fresnel(hit->reflectance, -glm::dot(eye.along, hit->normalWorld));
    const glm::dvec3 position = eye.from + hit->distance * eye.along;
    if (!(weight > 1e-4) || !lit(position)) continue;
    ReflectedRay ray;
    ray.from = position;
    ray.along = glm::reflect(eye.along, hit->normalWorld);
    ray.weight = weight;
    ray.seen = true;
    ray.eye = eye.from;
    ray.fromNormal = hit->normalWorld;
    ray.roughness = hit->roughness;
    collected.follow(ray);
  }
  return collected;
}

/// From everywhere in the space that the origin sees, in all directions.
Collector evenRays(const FitPlace& place, const Probe& probe, int count, int first) {
  const Lit lit(place, probe);
  Collector collected(place);
  for (int i = 1; i <= 4 * count && static_cast<int>(collected.size()) < count; ++i) {
    const int index = first + i;
    const glm::dvec3 out = sphereDirection(vanDerCorput(index, 2), vanDerCorput(index, 3));
    const std::optional<SurfaceHit> wall = place.captured.first(probe.origin, out);
    if (!wall) continue;
    ReflectedRay ray;
    ray.from = probe.origin + out * (wall->distance * std::cbrt(vanDerCorput(index, 5)));
    ray.along = sphereDirection(vanDerCorput(index, 7), vanDerCorput(index, 11));
    ray.weight = 1.0;
    if (lit(ray.from)) collected.follow(ray);
  }
  return collected;
}

}  // namespace

ReflectedRays reflectedRays(const FitPlace& place, const Probe& probe, int count, double turn) {
  const int evenCount = static_cast<int>(kEvenShare * count), seenCount = count - evenCount;
  const int first = static_cast<int>(turn * 100000.0);
  std::optional<Collector> seen;
  for (const bool rough : {false, true}) {
    for (const bool standing : {false, true}) {
      if (!standing && place.eyes.empty()) continue;
      if (seen && seen->size() >= static_cast<std::size_t>(seenCount / 10)) continue;
      Collector tried = seenReflections(place, probe, seenCount, first, standing, rough);
      if (!seen || tried.size() > seen->size()) seen = std::move(tried);
    }
  }
  Collector even = evenRays(place, probe, evenCount, first);
  ReflectedRays all;
  if (!even.empty()) even.moveTo(all, seen->empty() ? 1.0 : kEvenShare);
  if (!seen->empty()) seen->moveTo(all, even.empty() ? 1.0 : 1.0 - kEvenShare);
  return all;
}

}  // namespace boxprobe
