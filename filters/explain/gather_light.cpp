#include "filters/explain/gather_light.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "filters/core/base/fixed_text.h"
#include "filters/core/geometry/probe_shares.h"
#include "filters/math/shared/openness_math.h"

namespace boxprobe {

namespace {

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

/// The lookup of a planar mirror's picture, as at the end of bpGatherLight.
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

/// The end of bpAddLamps in shaders/gpu/lamps.glsl.
void addLampsInMap(const ExplainInput& in, float roughness, GatheredLight& out) {
  const auto lamps = std::find_if(in.probes.begin(), in.probes.end(), [](const auto& p) { return !p.lamps.empty(); });
  if (lamps == in.probes.end()) return;
  const float share = shading::lampsByShape(roughness);
  out.specular += (1.0f - share) * out.lampsInMap * shading::lampColor(out.lampsF0, lamps->lampGlossy.front());
  out.lampsF0 *= share;
  out.lampsF90 *= share;
}

}  // namespace

// The same order of steps as bpGatherLight in shaders/gpu/probe_lighting.glsl.
GatheredLight gatherLight(const ExplainInput& in, const glm::vec3& normal, float roughness,
                          const Reflectance& reflectance) {
  SurfacePoint s = in.surface;
  s.normalWorld = normal;
  const glm::vec3 reflection = shading::reflectedView(normal, s.viewWorld);
  GatheredLight out;
  std::vector<float> influences;
  std::vector<int> groups;
  for (const ExplainedProbe& probe : in.probes) {
    out.probes.push_back(explainProbe(probe, s, reflection, roughness, reflectance, in.skyMaps));
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
    // A smaller share is invisible and not sampled.
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
    out.lampsF0 += share * p.lampsF0;
    out.lampsF90 += share * p.lampsF90;
    out.lampsInMap += share * p.lampsInMap;
    out.lookups += static_cast<int>(p.lookups.size()) + p.distanceLookups;
    if (p.captured)
      out.brightestTexel = std::max(out.brightestTexel, brightest(p.lookups, in.probes[i].lookedUp()->radiance));
  }
  addLampsInMap(in, roughness, out);
  if (!in.weights && !in.probes.empty()) remaining = 0.0f;
  if (in.sky && in.skyMaps != nullptr && remaining > 1.0e-5f) {
    const CubeMap& map = in.skyMaps->radiance;
    out.skyWeight = remaining;
    out.skyLevel = shading::levelForRoughness(roughness, map.maxLevel());
    out.skyValue = glm::vec3(map.fetch(reflection, out.skyLevel));
    const float open = in.openness ? in.openness->at(s.positionWorld, normal) : 1.0f;
    if (in.openness) {
      out.skyValue *= shading::reflectedOpenness(open, glm::dot(normal, s.viewWorld), roughness);
    }
    out.specular += remaining * out.skyValue;
    out.irradiance += remaining * open * irradianceAt(normal, in.skyMaps->irradiance);
    ++out.lookups;
    for (const TexelShare& t : map.footprint(reflection, out.skyLevel)) {
      out.brightestTexel = std::max(out.brightestTexel, largestComponent(map.texel(t.level, t.face, t.column, t.row)));
    }
  }
  if (in.mirror != nullptr) {
    out.mirror = explainMirror(*in.mirror, s, normal, roughness);
    out.mirror->share = given + remaining;
    out.specular = (1.0f - out.mirror->coverage) * out.specular + out.mirror->share * out.mirror->light;
    out.lampsF0 *= 1.0f - out.mirror->coverage;
    out.lampsF90 *= 1.0f - out.mirror->coverage;
    out.lookups += out.mirror->fetches;
    out.brightestTexel = std::max(out.brightestTexel, largestComponent(glm::vec4(out.mirror->light, 0.0f)));
  }
  return out;
}

GatheredLight gatherAlong(const ExplainInput& in, const glm::dvec3& positionWorld, const glm::vec3& direction,
                          float roughness) {
  ExplainInput moved = in;
  moved.surface.positionWorld = positionWorld;
  moved.surface.viewWorld = direction;
  return gatherLight(moved, direction, roughness, {1.0f, 1.0f});
}

GatheredGlass gatherForGlass(const ExplainInput& in, const glm::dvec3& positionWorld, const glm::vec3& direction,
                             float roughness) {
  const GatheredLight light = gatherAlong(in, positionWorld, direction, roughness);
  GatheredGlass found{light.specular, light.lookups, light.brightestTexel, {}};
  std::vector<Phrase> sources;
  const auto add = [&sources](const Phrase& source, float share) {
    if (share > 0.0f) sources.push_back(source.arg(fixedText(100.0 * double(share), 1)));
  };
  for (const ProbeExplanation& p : light.probes) add(Phrase::tr("probe \"%1\" %2 %").arg(p.name), p.weight);
  add(Phrase::tr("sky %1 %"), light.skyWeight);
  found.sources = commaList(sources);
  return found;
}

}  // namespace boxprobe
