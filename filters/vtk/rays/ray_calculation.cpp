// See ray_calculation.h.
#include "filters/vtk/rays/ray_calculation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numeric>

#include "filters/explain/lookup_record.h"
#include "filters/math/cube/distance_cube.h"

namespace boxprobe {

namespace {

// A floor in the box's face is not outside it, nor is a position with float rounding: the same skin as that of the
// influence, relative to the box.
constexpr float kOutsideSkin = 1.0e-4f;
// Hits from here on mean "none": techniques return 3e38.
constexpr float kFarthestHit = 1.0e38f;

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Zero for vectors without a direction. Divides by the largest component first, so that squares do not underflow or
// overflow.
glm::dvec3 unitOrZero(const glm::dvec3& v) {
  if (!finite(v)) return glm::dvec3(0.0);
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0.0 ? glm::normalize(v / largest) : glm::dvec3(0.0);
}

bool outside(const glm::vec3& p, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 size = high - low;
  const float skin = kOutsideSkin * std::max({size.x, size.y, size.z});
  return glm::any(glm::lessThan(p, low - skin)) || glm::any(glm::greaterThan(p, high + skin));
}

// Rays have no material: Schlick's F0 of a non-metal of index 1.5.
constexpr float kRayF0 = 0.04f;

float meanReflectance(const SurfaceRay& ray) {
  const double facing = std::clamp(glm::dot(ray.normalWorld, ray.viewWorld), 0.0, 1.0);
  return static_cast<float>(kRayF0 + (1.0 - kRayF0) * std::pow(1.0 - facing, 5.0));
}

glm::vec3 inProbeFrame(const ProbeGeometry& g, const glm::dvec3& positionWorld) {
  return glm::vec3(glm::transpose(g.worldFromProbe) * (positionWorld - g.originWorld));
}

}  // namespace

SurfaceRay surfaceRay(const glm::dvec3& positionWorld, const glm::dvec3& normalWorld, float roughness,
                      const RayView& view) {
  SurfaceRay ray;
  ray.positionWorld = positionWorld;
  ray.roughness = std::isfinite(roughness) ? std::clamp(roughness, 0.0f, 1.0f) : 0.0f;
  ray.normalWorld = unitOrZero(normalWorld);
  ray.viewWorld = unitOrZero(view.parallel ? -view.viewDirection : view.eyeWorld - positionWorld);
  if (ray.normalWorld == glm::dvec3(0.0)) ray.status |= kRayNoNormal;
  if (ray.viewWorld == glm::dvec3(0.0)) ray.status |= kRayEyeOnPoint;
  if (!ray.reflects()) return ray;
  const double nDotV = glm::dot(ray.normalWorld, ray.viewWorld);
  if (nDotV <= 0.0) ray.status |= kRayFromBehind;
  ray.reflectionWorld = glm::normalize(2.0 * std::max(nDotV, 0.0) * ray.normalWorld - ray.viewWorld);
  return ray;
}

ProbeRay probeRay(const SurfaceRay& ray, const RayProbe& probe) {
  const ProbeGeometry& g = probe.geometry;
  const glm::dmat3 probeFromWorld = glm::transpose(g.worldFromProbe);
  shading::ProbeShape shape = probeShape(g, probe.maxLevel, ray.roughness);
  const bool seen = probe.distances && !probe.distances->empty();
  const std::optional<DistanceCube> distances =
      seen ? std::optional<DistanceCube>(std::in_place, *probe.distances) : std::nullopt;
  const glm::mat3 mapFromProbe(g.mapFromProbe);
  shading::ProbeData data;
  std::shared_ptr<const Relief> relief;
  std::shared_ptr<const ReliefBlocks> blocks;
  if (seen && projectionRows()[static_cast<std::size_t>(g.technique.projection)].distances) {
    relief = probe.relief.of(*probe.distances);
    blocks = probe.relief.blocks(*relief, g.boxMin, g.boxMax, mapFromProbe);
  }
  data.relief = relief.get();
  data.blocks = blocks.get();
  data.mapFromProbe = g.mapTurned ? &mapFromProbe : nullptr;
  shape.slot = &data;
  shading::ShadingPoint point{};
  point.position = inProbeFrame(g, ray.positionWorld);
  point.normal = glm::vec3(probeFromWorld * ray.normalWorld);
  point.view = glm::vec3(probeFromWorld * ray.viewWorld);
  point.reflection = glm::vec3(probeFromWorld * ray.reflectionWorld);
  point.roughness = ray.roughness;
  point.fresnel = meanReflectance(ray);
  point.f0 = kRayF0;

  ProbeRay result;
  const shading::ProbeHit hit = shading::projectRay(shape, point.position, point.normal, point.reflection);
  result.direction = hit.direction;
  result.face = hit.face;
  if (hit.distance < kFarthestHit) {
    result.hitDistance = hit.distance;
    result.hitWorld = g.originWorld + g.worldFromProbe * glm::dvec3(hit.direction);
    if (outside(point.position, g.boxMin, g.boxMax)) result.status |= kRayPointOutside;
    if (outside(glm::vec3(0.0f), g.boxMin, g.boxMax)) result.status |= kRayOriginOutside;
  } else {
    result.status |= kRayNoProxy;
  }
  const EvaluationRow& evaluation = evaluationRows()[static_cast<std::size_t>(g.technique.evaluation)];
  result.lookups = recordLookups(evaluation.evaluate, shape, point).lookups;
  for (Lookup& lookup : result.lookups) lookup.level = std::clamp(lookup.level, 0.0f, probe.maxLevel);
  if (distances) {
    // Along the axes of the map. The same maximum distance as in explanations and in the shader.
    const float reach = 2.0f * glm::length(g.boxMax - g.boxMin);
    const glm::dmat3 mapFromWorld = g.mapFromProbe * probeFromWorld;
    const float t = shading::trueHitDistance(&*distances, shape, static_cast<float>(probe.distances->faceSize()),
                                             glm::vec3(mapFromWorld * (ray.positionWorld - g.originWorld)),
                                             glm::vec3(mapFromWorld * ray.reflectionWorld), reach);
    if (t < kFarthestHit) result.trueDistance = t;
  }
  return result;
}

std::vector<float> probeShares(const glm::dvec3& positionWorld, const std::vector<RayProbe>& probes) {
  std::vector<float> weights(probes.size());
  std::vector<std::size_t> order(probes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return probes[a].geometry.importance > probes[b].geometry.importance;
  });
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const ProbeGeometry& g = probes[i].geometry;
    weights[i] =
        shading::influenceWeight(inProbeFrame(g, positionWorld), g.influenceMin, g.influenceMax, g.rateMin, g.rateMax);
  }
  std::vector<float> shares(probes.size(), 0.0f);
  float remaining = 1.0f;
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first;
    float sum = 0.0f;
    const double importance = probes[order[first]].geometry.importance;
    while (end < order.size() && probes[order[end]].geometry.importance == importance) sum += weights[order[end++]];
    const float scale = remaining * shading::groupScale(sum);
    for (std::size_t i = first; i < end; ++i) shares[order[i]] = scale * weights[order[i]];
    remaining = shading::remainingAfter(remaining, sum);
    first = end;
  }
  return shares;
}

}  // namespace boxprobe
