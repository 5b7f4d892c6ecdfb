#include "filters/explain/explain_pixel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/matrix.hpp>

#include "filters/core/base/fixed_text.h"
#include "filters/core/geometry/probe_shares.h"
#include "filters/core/surface/direct_light.h"
#include "filters/explain/explain_shadow.h"
#include "filters/explain/lookup_record.h"
#include "filters/math/cube/distance_cube.h"
#include "filters/math/shared/coverage.h"

namespace boxprobe {

namespace {

glm::vec3 irradianceAt(const glm::vec3& n, const ShCoefficients& c) {
  return shading::shIrradiance(n, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]);
}

/// Counts a technique's fetches from the distances.
class CountedRelief : public shading::ReliefSampler {
 public:
  explicit CountedRelief(const shading::ReliefSampler* relief) : relief_(relief) {}
  glm::vec4 fetchRelief(const glm::vec3& direction) const override {
    ++count_;
    return relief_->fetchRelief(direction);
  }
  int count() const { return count_; }

 private:
  const shading::ReliefSampler* relief_;
  mutable int count_ = 0;
};

bool inside(const glm::vec3& p, const glm::vec3& low, const glm::vec3& high, float slack) {
  for (int i = 0; i < 3; ++i) {
    if (p[i] < low[i] - slack || p[i] > high[i] + slack) return false;
  }
  return true;
}

float largestComponent(const glm::vec4& v) {
  return std::max({v.x, v.y, v.z});
}

float brightest(const std::vector<Lookup>& lookups, const CubeMap& map) {
  float result = 0.0f;
  for (const Lookup& lookup : lookups) {
    for (const TexelShare& t : lookup.texels) {
      result = std::max(result, largestComponent(map.texel(t.level, t.face, t.column, t.row)));
    }
  }
  return result;
}

/// The sky that shows where a probe's lookups cover nothing: along R for all of them, or each along its own way, as
/// shaders/gpu/open_sky.glsl and fetch_probe_open.glsl.
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

/// What one probe gives: the technique run once more with every fetch recorded.
ProbeExplanation explainProbe(const ExplainedProbe& probe, const SurfacePoint& s, const glm::vec3& reflection,
                              float roughness, float fresnel, const BakedMaps* sky) {
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
    light = probe.maps->light.of(probe.maps->radiance);
  data.light = light.get();
  shape.slot = &data;
  const shading::ShadingPoint point{
      e.positionProbe, turned(s.normalWorld), turned(s.viewWorld), e.reflectionProbe, roughness, s.pixel, s.frame,
      fresnel};
  const shading::ProbeHit hit = shading::projectRay(shape, point.position, point.normal, point.reflection);
  if (g.occluded) {
    e.occlusion = shading::boxOcclusion(hit.distance, g.occlusion.x, g.occlusion.y, g.occlusion.z);
  }
  e.lookupDirection = hit.direction;
  e.face = hit.face;
  constexpr float kNoHit = 1.0e38f;
  if (hit.face >= 0) {
    // Of the box itself, whatever was made of it.
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
    const RecordedLookups record = recordLookups(evaluate, probe.maps->radiance, g, shape, point);
    if (relief) {
      const CountedRelief counted(relief.get());
      data.relief = &counted;
      evaluate(&probe.maps->radiance, shape, point);
      e.distanceLookups = counted.count();
      data.relief = relief.get();
    }
    e.specular = glm::vec3(record.value);
    if (probe.open && sky != nullptr) {
      const glm::mat3 worldFromProbe(g.worldFromProbe);
      explainOpening(e, record, shape, point, *sky, reflection, g.rotated ? &worldFromProbe : nullptr,
                     looksUpPieces(g.technique));
    }
    e.lookups = record.lookups;
    if (distances) {
      const float reach = 2.0f * glm::length(g.boxMax - g.boxMin);
      const float faceSize = static_cast<float>(probe.maps->distance.faceSize());
      // Looked for along the axes of the map.
      const auto inMap = [&](const glm::vec3& v) { return g.mapTurned ? mapFromProbe * v : v; };
      const float t = shading::trueHitDistance(&*distances, shape, faceSize, inMap(e.positionProbe),
                                               inMap(e.reflectionProbe), reach);
      if (t < kNoHit) e.trueDistance = t;
    }
  }
  const BakedMaps* diffuse = e.captured ? probe.maps : sky;
  if (diffuse != nullptr) e.irradiance = irradianceAt(s.normalWorld, diffuse->irradiance);
  if (e.captured && probe.open && sky != nullptr) e.irradiance += irradianceAt(s.normalWorld, probe.openSky);
  return e;
}

struct Gathered {
  glm::vec3 specular{0.0f};
  glm::vec3 irradiance{0.0f};
  std::vector<ProbeExplanation> probes;
  float skyWeight = 0.0f, skyLevel = 0.0f;
  glm::vec3 skyValue{0.0f};
  int lookups = 0;
  float brightestTexel = 0.0f;
  std::optional<MirrorExplanation> mirror;
};

/// The lookup in a planar mirror's picture, as at the end of bpGatherLight.
MirrorExplanation explainMirror(const shading::MirrorLook& look, const SurfacePoint& s, const glm::vec3& normal,
                                float roughness) {
  MirrorExplanation e;
  const glm::vec3 position(s.positionWorld - s.eyeWorld);
  const glm::vec4 value = shading::mirroredLight(look, position, normal, s.viewWorld, roughness);
  e.light = glm::vec3(value);
  e.coverage = value.w;
  e.fetches = shading::mirrorFetches(look, position, normal, s.viewWorld, roughness);
  const glm::vec3 reflection = shading::reflectedView(normal, s.viewWorld);
  const float alpha = roughness * roughness, solidAngle = 12.5663706f * alpha * alpha;
  const float height = shading::mirrorHeight(look, position, reflection, solidAngle, 3) * look.farHeight;
  e.hitDistance = height / std::max(glm::dot(reflection, look.normal), 1.0e-2f);
  e.level = shading::mirrorLevel(look, position + e.hitDistance * reflection, e.hitDistance, solidAngle);
  return e;
}

/// The surface's Fresnel reflectance at N.V, mean of its colours: Schlick between F0 and F90.
float meanFresnel(const glm::vec3& f0, const glm::vec3& f90, float nDotV) {
  const glm::vec3 f = f0 + (f90 - f0) * std::pow(1.0f - nDotV, 5.0f);
  return glm::dot(f, glm::vec3(1.0f / 3.0f));
}

// The same order of steps as bpGatherLight in shaders/gpu/probe_lighting.glsl.
Gathered gather(const ExplainInput& in, const glm::vec3& normal, float roughness, float fresnel) {
  SurfacePoint s = in.surface;
  s.normalWorld = normal;
  const glm::vec3 reflection = shading::reflectedView(normal, s.viewWorld);
  Gathered out;
  std::vector<float> influences;
  std::vector<int> groups;
  for (const ExplainedProbe& probe : in.probes) {
    out.probes.push_back(explainProbe(probe, s, reflection, roughness, fresnel, in.skyMaps));
    influences.push_back(out.probes.back().influence);
    groups.push_back(probe.group);
  }
  const ProbeShares shares =
      in.shares.empty() ? shareOut(influences, groups, in.onlyProbes) : ProbeShares{in.shares, in.skyShare};
  float remaining = shares.sky, given = 0.0f;
  for (std::size_t i = 0; i < out.probes.size(); ++i) {
    ProbeExplanation& p = out.probes[i];
    p.weight = in.weights ? shares.probes[i] : 1.0f;
    const float share = p.weight * p.intensity;
    // Less cannot show and is not fetched.
    if (in.weights && share <= 1.0e-5f) {
      p.lookups.clear();
      p.distanceLookups = 0;
      p.weight = 0.0f;
      continue;
    }
    given += share;
    out.specular += share * p.occlusion.value_or(1.0f) * p.specular;
    if (p.coverage) {
      out.specular += share * (p.openByLookup ? p.occlusion.value_or(1.0f) : 1.0f) * (1.0f - *p.coverage) * p.openSky;
      out.lookups += p.openLookups;
      for (const TexelShare& t : in.skyMaps->radiance.footprint(reflection, p.openSkyLevel)) {
        out.brightestTexel = std::max(out.brightestTexel,
                                      largestComponent(in.skyMaps->radiance.texel(t.level, t.face, t.column, t.row)));
      }
    }
    out.irradiance += share * p.irradiance;
    out.lookups += static_cast<int>(p.lookups.size()) + p.distanceLookups;
    if (p.captured)
      out.brightestTexel = std::max(out.brightestTexel, brightest(p.lookups, in.probes[i].maps->radiance));
  }
  if (!in.weights && !in.probes.empty()) remaining = 0.0f;
  if (in.sky && in.skyMaps != nullptr && remaining > 1.0e-5f) {
    const CubeMap& map = in.skyMaps->radiance;
    out.skyWeight = remaining;
    out.skyLevel = shading::levelForRoughness(roughness, map.maxLevel());
    out.skyValue = glm::vec3(map.fetch(reflection, out.skyLevel));
    out.specular += remaining * out.skyValue;
    out.irradiance += remaining * irradianceAt(normal, in.skyMaps->irradiance);
    ++out.lookups;
    for (const TexelShare& t : map.footprint(reflection, out.skyLevel)) {
      out.brightestTexel = std::max(out.brightestTexel, largestComponent(map.texel(t.level, t.face, t.column, t.row)));
    }
  }
  if (in.mirror != nullptr) {
    out.mirror = explainMirror(*in.mirror, s, normal, roughness);
    out.mirror->share = given + remaining;
    out.specular = (1.0f - out.mirror->coverage) * out.specular + out.mirror->share * out.mirror->light;
    out.lookups += out.mirror->fetches;
    out.brightestTexel = std::max(out.brightestTexel, largestComponent(glm::vec4(out.mirror->light, 0.0f)));
  }
  return out;
}

// The same from another place, round about a direction: what glass is looked through, and mirrors within.
Gathered gatherAlong(const ExplainInput& in, const glm::dvec3& position, const glm::vec3& direction, float roughness) {
  ExplainInput moved = in;
  moved.surface.positionWorld = position;
  moved.surface.viewWorld = direction;
  return gather(moved, direction, roughness, 1.0f);
}

GatheredGlass lookUpGlass(const ExplainInput& in, const glm::dvec3& position, const glm::vec3& direction,
                          float roughness) {
  const Gathered light = gatherAlong(in, position, direction, roughness);
  GatheredGlass found{light.specular, light.lookups, light.brightestTexel, {}};
  const auto add = [&found](const std::string& name, float share) {
    if (share <= 0.0f) return;
    found.sources += (found.sources.empty() ? "" : ", ") + name + " " + fixedText(100.0 * double(share), 1) + " %";
  };
  for (const ProbeExplanation& p : light.probes) add("probe \"" + p.name + "\"", p.weight);
  add("sky", light.skyWeight);
  return found;
}

void addNotes(Explanation& e) {
  const SurfacePoint& s = e.surface;
  if (s.opacity < 0.999f) {
    e.notes.emplace_back("The surface is translucent: what lies behind it shows through and is not part of this.");
  }
  if (e.glass && e.glass->stands > 0.0f) {
    e.notes.push_back("Light passes the glass nearly straight: " + fixedText(100.0 * double(e.glass->stands), 1) +
                      " % of what the picture shows here is what is drawn behind, in place of the lookup, and is not "
                      "part of this.");
  }
  if (e.probes.empty()) {
    e.notes.emplace_back(
        "No probe lights this object, because none reaches it or its probeMode is off: it reflects the sky alone, "
        "uncorrected.");
  }
  for (const ProbeExplanation& p : e.probes) {
    if (p.weight <= 0.0f) {
      e.notes.push_back("Probe \"" + p.name + "\": its weight is 0 here, so nothing is fetched from it.");
      continue;
    }
    if (!p.captured) e.notes.push_back("Probe \"" + p.name + "\" has not been captured yet: it reflects nothing.");
    if (!p.hitDistance) {
      e.notes.push_back("Probe \"" + p.name + "\": technique " + p.technique +
                        " has no box to hit, so hit point and distance are undefined; the surroundings are taken to be "
                        "infinitely far away.");
    }
    if (!p.slabFactors) continue;
    const float skin = 1.0e-4f * glm::length(p.boxMax - p.boxMin);
    if (!inside(glm::vec3(0.0f), p.boxMin, p.boxMax, 0.0f)) {
      e.notes.push_back("Probe \"" + p.name +
                        "\": the capture origin lies outside the projection box, so part of what the lookup names was "
                        "never seen from inside the box.");
    }
    if (!inside(p.positionProbe, p.boxMin, p.boxMax, skin)) {
      e.notes.push_back("Probe \"" + p.name +
                        "\": the point lies outside the projection box; distances to planes behind it count as 0 and "
                        "the hit is pulled on to the box.");
    }
    if (!p.trueDistance && p.captured) {
      e.notes.push_back(
          "Probe \"" + p.name +
          "\": its distances do not tell the true hit here (open sky, or hidden from the capture origin).");
    }
  }
}

}  // namespace

Explanation explainPixel(const ExplainInput& in) {
  Explanation e;
  e.hit = true;
  e.surface = in.surface;
  const SurfacePoint& s = in.surface;
  e.emissive = s.emissive;
  if (in.lighting == ExplainInput::Lighting::Unlit) {
    e.color = e.emissive;
    e.notes.emplace_back("The material is unlit: it shows its colour, no light and no probe.");
    return e;
  }
  if (glm::dot(s.normalWorld, s.normalWorld) < 0.25f) {
    e.notes.emplace_back("The surface has no normal here, so there is no reflected ray to project.");
    return e;
  }
  e.reflectionWorld = shading::reflectedView(s.normalWorld, s.viewWorld);
  const float facing = glm::dot(s.normalWorld, s.viewWorld);
  if (facing <= 0.0f) {
    e.notes.emplace_back(
        "The shading normal points away from the eye: mirrored in it the ray would start below the surface, so it goes "
        "straight on.");
  }
  e.nDotV = std::clamp(facing, 1.0e-5f, 1.0f);
  e.f0 = glm::mix(glm::vec3(s.baseF0), s.albedo, s.metallic);
  const float f90 = std::clamp(glm::dot(e.f0, glm::vec3(50.0f * 0.33f)), 0.0f, 1.0f);
  const glm::vec3 edge = glm::mix(glm::vec3(f90), glm::vec3(1.0f), s.metallic);
  std::vector<glm::vec3> arrives(in.lights.size(), glm::vec3(1.0f));
  if (in.lighting == ExplainInput::Lighting::Probes) e.shadows = explainShadows(in);
  for (const LightShadow& shadow : e.shadows) arrives[static_cast<std::size_t>(shadow.light)] = shadow.through;
  e.direct = directLight(s, e.f0, edge, in.lights, &arrives);

  if (in.lighting == ExplainInput::Lighting::Probes) {
    const std::optional<shading::GlassView> through =
        in.glass ? std::optional<shading::GlassView>(lookThrough(*in.glass, s)) : std::nullopt;
    Gathered light = through && through->followed
                         ? gatherAlong(in, s.eyeWorld + glm::dvec3(through->mirrored.position),
                                       through->mirrored.direction, std::sqrt(through->mirrored.alpha))
                         : gather(in, s.normalWorld, s.roughness, meanFresnel(e.f0, edge, e.nDotV));
    e.brdf = sampleBrdf(*in.brdf, e.nDotV, s.roughness);
    e.specular = s.occlusion * light.specular * (e.f0 * e.brdf.x + edge * e.brdf.y);
    e.diffuse = s.occlusion * (1.0f - e.f0) * (1.0f - s.metallic) * light.irradiance * s.albedo;
    if (through) {
      const float reflected = through->reflectance >= 1.0f ? 1.0f : through->reflectance * (e.brdf.x + e.brdf.y);
      const glm::vec3 factor = glm::mix(reflected * mirrorTransmittance(*in.glass, s, *through),
                                        e.f0 * e.brdf.x + edge * e.brdf.y, s.metallic);
      e.specular = s.occlusion * light.specular * factor;
      e.diffuse *= 1.0f - in.glass->transmission;
      e.glass = explainGlass(*in.glass, s, *through, reflected,
                             [&in](const glm::dvec3& position, const glm::vec3& direction, float roughness) {
                               return lookUpGlass(in, position, direction, roughness);
                             });
      e.glass->passed *= s.occlusion;
    }
    e.probes = std::move(light.probes);
    e.skyWeight = light.skyWeight;
    e.mirror = light.mirror;
    e.skyLevel = light.skyLevel;
    e.skyValue = light.skyValue;
    e.lookupCount = light.lookups;
    for (const LightShadow& shadow : e.shadows) e.lookupCount += static_cast<int>(shadow.probes.size());
    e.brightestTexel = light.brightestTexel;
    if (s.coatStrength > 0.0f) {
      const float coatNDotV = std::clamp(glm::dot(s.coatNormalWorld, s.viewWorld), 1.0e-5f, 1.0f);
      const Gathered coat =
          gather(in, s.coatNormalWorld, s.coatRoughness, meanFresnel(glm::vec3(s.coatF0), glm::vec3(1.0f), coatNDotV));
      const glm::vec2 brdf = sampleBrdf(*in.brdf, coatNDotV, s.coatRoughness);
      const float fresnel = s.coatF0 + (1.0f - s.coatF0) * std::pow(1.0f - coatNDotV, 5.0f);
      e.coat = s.occlusion * coat.specular * (s.coatF0 * brdf.x + brdf.y) * fresnel * s.coatStrength;
      e.lookupCount += coat.lookups;
      e.brightestTexel = std::max(e.brightestTexel, coat.brightestTexel);
    }
    if (e.glass) {
      e.lookupCount += e.glass->lookups;
      e.brightestTexel = std::max(e.brightestTexel, e.glass->brightestTexel);
    }
    float largest = 0.0f;
    for (std::size_t i = 0; i < e.probes.size(); ++i) {
      if (e.probes[i].weight <= largest) continue;
      largest = e.probes[i].weight;
      e.dominant = static_cast<int>(i);
    }
    addNotes(e);
    for (const ExplainedProbe& probe : in.probes) {
      if (!probe.automatic) continue;
      e.notes.push_back("Probe \"" + probe.name + "\": auto chose " + techniqueId(probe.geometry.technique) +
                        " for this object's roughness.");
    }
  }
  e.color = e.direct + e.diffuse + e.specular + e.coat + e.emissive;
  if (e.glass) e.color += e.glass->light();
  return e;
}

}  // namespace boxprobe
