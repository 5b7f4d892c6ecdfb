#include "filters/explain/explain_probe.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "filters/explain/explain_shadow.h"
#include "filters/explain/lookup_record.h"
#include "filters/math/cube/distance_cube.h"
#include "filters/math/shared/coverage.h"

namespace boxprobe {

namespace {

/// Counts a technique's distance lookups.
class CountedRelief : public shading::ReliefSampler {
 public:
  explicit CountedRelief(const shading::ReliefSampler* relief) : relief_(relief) {}
  glm::vec4 fetchRelief(const glm::vec3& direction, float level) const override {
    ++count_;
    return relief_->fetchRelief(direction, level);
  }
  float reliefSize() const override { return relief_->reliefSize(); }
  int count() const { return count_; }

 private:
  const shading::ReliefSampler* relief_;
  mutable int count_ = 0;
};

/// The sky that shows where a probe's lookups have no coverage: along R for all of them, or along each lookup's own
/// direction, as in shaders/gpu/open_sky.glsl and fetch_probe_open.glsl.
void explainOpening(ProbeExplanation& e, const RecordedLookups& record, const shading::ProbeShape& shape,
                    const shading::ShadingPoint& point, const BakedMaps& sky, const glm::vec3& reflection,
                    const glm::mat3* worldFromProbe, bool byLookup) {
  const float maxLevel = sky.radiance.maxLevel();
  e.openByLookup = byLookup;
  if (!byLookup) {
    e.coverage = std::clamp(record.value.a, 0.0f, 1.0f);
    e.openSkyLevel = shading::levelForRoughness(point.roughness, maxLevel);
    e.openSky = glm::vec3(sky.radiance.fetch(reflection, e.openSkyLevel));
    e.openLookups = 1;
    return;
  }
  glm::vec3 sum(0.0f);
  float open = 0.0f;
  for (const Lookup& lookup : record.lookups) {
    const float share = std::clamp(1.0f - lookup.coverage, 0.0f, 1.0f);
    if (share <= 0.0f) continue;
    const glm::vec4 out =
        shading::openLookup(shape, point.position, lookup.direction, lookup.level, point.roughness * point.roughness);
    const glm::vec3 along = worldFromProbe != nullptr ? *worldFromProbe * glm::vec3(out) : glm::vec3(out);
    e.openSkyLevel = shading::levelForRoughness(out.w, maxLevel);
    sum += lookup.weight * share * glm::vec3(sky.radiance.fetch(along, e.openSkyLevel));
    open += lookup.weight * share;
    ++e.openLookups;
  }
  e.coverage = 1.0f - open;
  e.openSky = open > 0.0f ? sum / open : sum;
}

DiffuseExplanation explainDiffuse(const ExplainedProbe& probe, const glm::vec3& positionProbe,
                                  const glm::vec3& facingProbe, const glm::vec3& positionFromEye,
                                  const SurfacePoint& s) {
  DiffuseExplanation e;
  const DiffuseLattice& lattice = *probe.lattice;
  const shading::LatticeShape shape = lattice.shape();
  e.lattice = shading::latticeIrradiance(shape, positionProbe, facingProbe, s.normalWorld);
  e.known = shading::latticeKnown(shape, positionProbe);
  e.nodeCount = lattice.nodes;
  glm::vec3 place = shading::latticePlace(shape, positionProbe);
  if (shape.cut > 0.0f) place = shading::latticeSeen(shape, place, facingProbe);
  e.cutWays = lattice.cutWays;
  const glm::vec3 first = glm::min(glm::floor(place), shape.last - 1.0f), share = place - first;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 step(static_cast<float>(corner & 1), static_cast<float>(corner >> 1 & 1),
                         static_cast<float>(corner >> 2));
    const glm::vec3 weights = glm::mix(1.0f - share, share, step);
    LatticeNodeAtPoint node;
    node.node = glm::ivec3(first + step);
    node.positionProbe = lattice.low + (lattice.high - lattice.low) * (first + step) / shape.last;
    node.weight = weights.x * weights.y * weights.z;
    node.known = lattice.fetchLattice(first + step, DiffuseLattice::kParts - 1).w > 0.5f;
    if (node.weight > 0.0f) e.nodes.push_back(node);
  }
  std::stable_sort(e.nodes.begin(), e.nodes.end(), [](const auto& a, const auto& b) { return a.weight > b.weight; });
  for (std::size_t i = 0; i < probe.lamps.size(); ++i) {
    const SceneLamp& lamp = probe.lamps[i];
    const LampPolygon polygon = lampPolygon(lamp, s.eyeWorld);
    const float seen = i < probe.lampChannels.size() ? seenShare(probe, s, probe.lampChannels[i]) : 1.0f;
    const float filled = seen * shading::lampDiffuse(&polygon, positionFromEye, s.normalWorld);
    if (filled > 0.0f) e.lamps.push_back({lamp.node, filled * glm::vec3(lamp.radiance), filled});
  }
  const auto brightness = [](const LampAtPoint& lamp) { return lamp.light.x + lamp.light.y + lamp.light.z; };
  std::stable_sort(e.lamps.begin(), e.lamps.end(),
                   [&](const LampAtPoint& a, const LampAtPoint& b) { return brightness(a) > brightness(b); });
  return e;
}

}  // namespace

glm::vec3 irradianceAt(const glm::vec3& n, const ShCoefficients& c) {
  return shading::shIrradiance(n, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]);
}

ProbeExplanation explainProbe(const ExplainedProbe& probe, const SurfacePoint& s, const glm::vec3& reflection,
                              float roughness, const Reflectance& reflectance, const BakedMaps* sky) {
  const ProbeGeometry& g = probe.geometry;
  ProbeExplanation e;
  e.name = probe.name;
  e.index = probe.index;
  e.technique = techniqueId(g.technique);
  e.intensity = g.intensity;
  e.captured = probe.maps != nullptr;
  e.originWorld = g.originWorld;
  e.worldFromProbe = g.worldFromProbe;
  e.mapFromProbe = g.mapFromProbe;
  e.boxMin = g.boxMin;
  e.boxMax = g.boxMax;
  e.maxLevel = e.captured ? probe.maps->radiance.maxLevel() : 0.0f;

  // As in the shader: both relative to the eye first, in single precision.
  const glm::vec3 position(s.positionWorld - s.eyeWorld), origin(g.originWorld - s.eyeWorld);
  const glm::mat3 probeFromWorld = glm::transpose(glm::mat3(g.worldFromProbe));
  const auto turned = [&](const glm::vec3& v) { return g.rotated ? probeFromWorld * v : v; };
  e.positionProbe = turned(position - origin);
  e.reflectionProbe = turned(reflection);
  e.influence = shading::influenceWeight(e.positionProbe, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax);

  shading::ProbeShape shape = probeShape(g, e.maxLevel, roughness);
  e.bevel = g.bevelled ? shape.bevel : 0.0f;
  const bool seen = e.captured && !probe.maps->distance.empty();
  const std::optional<DistanceCube> distances =
      seen ? std::optional<DistanceCube>(std::in_place, probe.maps->distance) : std::nullopt;
  const glm::mat3 mapFromProbe(g.mapFromProbe);
  shading::ProbeData data;
  std::shared_ptr<const Relief> relief;
  std::shared_ptr<const ReliefBlocks> blocks;
  if (seen && projectionRows()[static_cast<std::size_t>(g.technique.projection)].distances) {
    relief = probe.maps->relief.of(probe.maps->distance);
    blocks = probe.maps->relief.blocks(*relief, g.boxMin, g.boxMax, mapFromProbe);
  }
  data.relief = relief.get();
  data.blocks = blocks.get();
  data.mapFromProbe = g.mapTurned ? &mapFromProbe : nullptr;
  std::shared_ptr<const LightTable> light;
  if (e.captured && chooses(g.technique, g.parameters, "sampling", "luminance"))
    light = probe.lookedUp()->light.of(probe.lookedUp()->radiance);
  data.light = light.get();
  shape.slot = &data;
  const shading::ShadingPoint point{
      e.positionProbe, turned(s.normalWorld), turned(s.viewWorld), e.reflectionProbe, roughness, s.pixel,
      s.frame,         reflectance.fresnel,   reflectance.f0};
  const shading::ProbeHit hit = shading::projectRay(shape, point.position, point.normal, point.reflection);
  if (g.occluded) {
    e.occlusion = shading::boxOcclusion(hit.distance, g.occlusion.x, g.occlusion.y, g.occlusion.z);
  }
  e.lookupDirection = hit.direction;
  e.face = hit.face;
  constexpr float kNoHit = 1.0e38f;
  if (hit.face >= 0) {
    // Of the sharp box, also if its edges are rounded.
    e.slabFactors = shading::slabFactors(point.position, point.reflection, g.boxMin, g.boxMax);
    const float box = std::min({e.slabFactors->x, e.slabFactors->y, e.slabFactors->z});
    if (hit.distance != box) e.boxDistance = box;
  }
  if (hit.distance < kNoHit) {
    e.hitDistance = hit.distance;
    e.hitWorld = g.originWorld + g.worldFromProbe * glm::dvec3(hit.direction);
  }
  if (e.captured) {
    const auto evaluate = evaluationRows()[static_cast<std::size_t>(g.technique.evaluation)].evaluate;
    const RecordedLookups record = recordLookups(evaluate, probe.lookedUp()->radiance, g, shape, point);
    if (relief) {
      const CountedRelief counted(relief.get());
      data.relief = &counted;
      evaluate(&probe.lookedUp()->radiance, shape, point);
      e.distanceLookups = counted.count();
      data.relief = relief.get();
    }
    e.specular = glm::vec3(record.value);
    if (probe.lampFree != nullptr) {
      e.lampsInMap = record.value.a;
      const shading::LampLobe lobe = shading::lampLobe(s.normalWorld, s.viewWorld, roughness);
      for (std::size_t i = 0; i < probe.lamps.size(); ++i) {
        const SceneLamp& lamp = probe.lamps[i];
        const LampPolygon polygon = lampPolygon(lamp, s.eyeWorld);
        const float share = i < probe.lampChannels.size() ? seenShare(probe, s, probe.lampChannels[i]) : 1.0f;
        const glm::vec2 lit = share * shading::lampGlossy(&polygon, position, lobe);
        e.lampsF0 += lit.x * probe.lampGlossy[i];
        e.lampsF90 += lit.y * glm::vec3(lamp.radiance);
      }
    }
    if (probe.open && sky != nullptr) {
      const glm::mat3 worldFromProbe(g.worldFromProbe);
      explainOpening(e, record, shape, point, *sky, reflection, g.rotated ? &worldFromProbe : nullptr,
                     looksUpPieces(g.technique));
    }
    e.lookups = record.lookups;
    if (distances) {
      const float reach = 2.0f * glm::length(g.boxMax - g.boxMin);
      const float faceSize = static_cast<float>(probe.maps->distance.faceSize());
      // Searched along the axes of the map.
      const auto inMap = [&](const glm::vec3& v) { return g.mapTurned ? mapFromProbe * v : v; };
      const float t = shading::trueHitDistance(&*distances, shape, faceSize, inMap(e.positionProbe),
                                               inMap(e.reflectionProbe), reach);
      if (t < kNoHit) e.trueDistance = t;
    }
  }
  if (probe.lattice) {
    e.diffuse = explainDiffuse(probe, e.positionProbe, turned(s.normalWorld), position, s);
    e.irradiance = e.diffuse.lattice;
    for (const LampAtPoint& lamp : e.diffuse.lamps) e.irradiance += lamp.light;
    return e;
  }
  const BakedMaps* diffuse = e.captured ? probe.maps : sky;
  if (diffuse != nullptr) e.irradiance = irradianceAt(s.normalWorld, diffuse->irradiance);
  if (e.captured && probe.open && sky != nullptr) e.irradiance += irradianceAt(s.normalWorld, probe.openSky);
  return e;
}

}  // namespace boxprobe
