// See ray_builder.h.
#include "filters/vtk/rays/ray_builder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/geometry/light_shadow.h"
#include "filters/explain/explain_shadow.h"
#include "filters/vtk/rays/ray_scene.h"

namespace boxprobe {

namespace {

// Probes with a smaller share are not sampled in the picture either (shaders/gpu/probe_share.glsl).
constexpr float kSmallestShare = 1.0e-5f;
// Rays start this far above their own surface, relative to the scene, so that rounding does not make them hit it.
constexpr double kStartSkin = 1.0e-6;

glm::dvec3 unit(const glm::vec3& v) {
  const glm::dvec3 d(v);
  const double length = glm::length(d);
  return length > 0.0 ? d / length : d;
}

}  // namespace

std::optional<double> RayBuilder::sceneDistance(const SurfaceRay& ray) const {
  if (settings_.scene == nullptr) return std::nullopt;
  const double skin = kStartSkin * settings_.scene->diagonal();
  const glm::dvec3 start = ray.positionWorld + skin * ray.normalWorld;
  const auto hit = settings_.scene->firstHit(start, ray.reflectionWorld, skin, settings_.scene->reachFrom(start));
  if (!hit) return std::nullopt;
  // Where the ray itself, not the raised one, meets the plane that was hit.
  const double slope = glm::dot(hit->facing, ray.reflectionWorld);
  const double distance = glm::dot(hit->facing, hit->positionWorld - ray.positionWorld) / slope;
  return std::abs(slope) > 1.0e-6 && distance > 0.0 ? distance : hit->distance;
}

void RayBuilder::add(const RayLine& line) {
  if (settings_.kinds[static_cast<std::size_t>(line.kind)]) lines_.add(line);
}

void RayBuilder::addPoint(int point, const SurfaceRay& ray) {
  const RayView& view = settings_.view;
  RayLine line;
  line.point = point;
  line.status = ray.status;
  line.hitPoint = ray.positionWorld;
  if ((ray.status & kRayEyeOnPoint) == 0) {
    line.kind = RayKind::Eye;
    line.from = view.parallel ? ray.positionWorld + settings_.maximumLength * ray.viewWorld : view.eyeWorld;
    line.to = ray.positionWorld;
    add(line);
  }
  if ((ray.status & kRayNoNormal) == 0) {
    line.kind = RayKind::Normal;
    line.from = ray.positionWorld;
    line.to = ray.positionWorld + settings_.normalLength * ray.normalWorld;
    add(line);
  }
  if (!ray.reflects()) return;
  const std::optional<double> truth = sceneDistance(ray);
  const std::vector<float> shares = probeShares(ray.positionWorld, settings_.probes);
  bool any = false;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const float fetched = shares[i] * settings_.probes[i].geometry.intensity;
    if (settings_.contributingOnly && fetched <= kSmallestShare) continue;
    addProbe(point, ray, static_cast<int>(i), shares[i], truth);
    any = true;
  }
  if (!any) addSkyRay(point, ray);
}

void RayBuilder::addGlass(int point, const SurfaceRay& ray, const GlassSurface& glass, bool back) {
  if (!ray.reflects()) return;
  const auto path = glassPath(glass, ray, settings_.view, back);
  if (!path) return;
  RayLine line;
  line.point = point;
  line.status = ray.status;
  line.kind = RayKind::Within;
  for (std::size_t i = 0; i + 1 < path->within.size(); ++i) {
    line.from = path->within[i];
    line.to = line.hitPoint = path->within[i + 1];
    add(line);
  }
  const std::vector<float> shares = probeShares(path->leaving.positionWorld, settings_.probes);
  line.kind = RayKind::Refracted;
  line.from = path->leaving.positionWorld;
  bool any = false;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (settings_.contributingOnly && shares[i] * settings_.probes[i].geometry.intensity <= kSmallestShare) continue;
    const ProbeRay found = probeRay(path->leaving, settings_.probes[i]);
    line.probe = static_cast<int>(i);
    line.status = ray.status | found.status;
    line.to = line.hitPoint =
        found.hitDistance ? found.hitWorld : line.from + settings_.maximumLength * path->leaving.reflectionWorld;
    line.face = found.face;
    line.hitDistance = found.hitDistance.value_or(-1.0);
    line.direction = glm::dvec3(found.direction);
    line.weight = shares[i];
    add(line);
    any = true;
  }
  if (any) return;
  line.status |= kRayNoProbe | kRayNoProxy;
  line.to = line.hitPoint = line.from + settings_.maximumLength * path->leaving.reflectionWorld;
  line.direction = path->leaving.reflectionWorld;
  add(line);
}

void RayBuilder::addSkyRay(int point, const SurfaceRay& ray) {
  RayLine line;
  line.kind = RayKind::Reflected;
  line.point = point;
  line.status = ray.status | kRayNoProbe | kRayNoProxy;
  line.from = ray.positionWorld;
  line.to = ray.positionWorld + settings_.maximumLength * ray.reflectionWorld;
  line.hitPoint = line.to;
  line.direction = ray.reflectionWorld;
  add(line);
}

void RayBuilder::addProbe(int point, const SurfaceRay& ray, int probe, float share,
                          std::optional<double> sceneDistance) {
  const RayProbe& p = settings_.probes[static_cast<std::size_t>(probe)];
  const ProbeRay found = probeRay(ray, p);
  const std::optional<double> truth = settings_.scene != nullptr ? sceneDistance : found.trueDistance;
  const glm::dvec3 end =
      found.hitDistance ? found.hitWorld : ray.positionWorld + settings_.maximumLength * ray.reflectionWorld;

  RayLine line;
  line.kind = RayKind::Reflected;
  line.point = point;
  line.probe = probe;
  line.status = ray.status | found.status;
  line.from = ray.positionWorld;
  line.to = end;
  line.face = found.face;
  line.hitPoint = end;
  line.hitDistance = found.hitDistance.value_or(-1.0);
  line.direction = glm::dvec3(found.direction);
  line.weight = share;
  line.trueDistance = truth.value_or(-1.0);
  const glm::dvec3 trueHit = ray.positionWorld + truth.value_or(0.0) * ray.reflectionWorld;
  if (truth && found.hitDistance) line.error = glm::length(trueHit - found.hitWorld);
  // The lookup with the largest weight represents the ray.
  const auto heaviest = std::max_element(found.lookups.begin(), found.lookups.end(),
                                         [](const Lookup& a, const Lookup& b) { return a.weight < b.weight; });
  if (heaviest != found.lookups.end()) {
    line.level = heaviest->level;
    line.lookupShare = heaviest->weight;
  }
  add(line);
  addLookups(line, found, p, ray);
  addShadows(line, ray, probe);
  if (truth) {
    line.kind = RayKind::TrueHit;
    line.to = trueHit;
    add(line);
  }
  if (line.error >= 0.0) {
    line.kind = RayKind::Error;
    line.from = found.hitWorld;
    line.to = trueHit;
    add(line);
  }
}

void RayBuilder::addShadows(const RayLine& common, const SurfaceRay& ray, int probe) {
  const RayProbe& p = settings_.probes[static_cast<std::size_t>(probe)];
  ExplainedProbe explained;
  explained.geometry = p.geometry;
  explained.coverage = p.coverage.get();
  for (std::size_t i = 0; i < std::min(settings_.lights.size(), kMostShadowLights); ++i) {
    if ((p.shadowLights >> i & 1u) == 0) continue;
    const ShadowRay found = shadowRay(explained, ray.positionWorld, ray.positionWorld, settings_.lights[i]);
    if (glm::dot(ray.normalWorld, glm::dvec3(found.toLight)) <= 0.0) continue;
    RayLine line = common;
    line.kind = RayKind::Shadow;
    line.to = line.hitPoint = found.shadow.hitWorld;
    line.hitDistance = static_cast<double>(found.shadow.distance);
    line.direction = found.shadow.hitWorld - p.geometry.originWorld;
    line.face = -1;
    line.trueDistance = line.error = -1.0;
    line.level = p.coverage ? static_cast<double>(found.shadow.level) : -1.0;
    const glm::vec3& t = found.shadow.through;
    line.through = p.coverage ? static_cast<double>(t.x + t.y + t.z) / 3.0 : -1.0;
    add(line);
  }
}

void RayBuilder::addLookups(const RayLine& common, const ProbeRay& found, const RayProbe& probe,
                            const SurfaceRay& ray) {
  const bool proxy = found.hitDistance.has_value();
  const ProbeGeometry& g = probe.geometry;
  for (const Lookup& lookup : found.lookups) {
    RayLine line = common;
    line.direction = glm::dvec3(lookup.direction);
    line.level = lookup.level;
    line.lookupShare = lookup.weight;
    // With a proxy the vector ends on it; without one it is a direction only.
    const glm::dvec3 vector = proxy ? line.direction : settings_.maximumLength * unit(lookup.direction);
    line.kind = RayKind::Lookup;
    line.from = g.originWorld;
    line.to = g.originWorld + g.worldFromProbe * vector;
    line.hitPoint = line.to;
    add(line);
    if (proxy && lookup.direction != found.direction) {
      line.kind = RayKind::Sample;
      line.from = ray.positionWorld;
      line.hitDistance = glm::length(line.to - line.from);
      // Face, true hit and error are those of R.
      line.face = -1;
      line.trueDistance = line.error = -1.0;
      add(line);
    }
  }
}

}  // namespace boxprobe
