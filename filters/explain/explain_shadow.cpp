#include "filters/explain/explain_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "filters/core/geometry/light_shadow.h"
#include "filters/core/geometry/probe_shares.h"
#include "filters/math/shared/coverage.h"

namespace boxprobe {

namespace {

/// The probe's transmittance for light from `toLight`.
ProbeShadow probeShadow(const ExplainedProbe& probe, const SurfacePoint& s, const glm::vec3& toLight, float tangent,
                        const Light& light) {
  const ProbeGeometry& g = probe.geometry;
  ProbeShadow shadow;
  shadow.name = probe.name;
  const glm::mat3 probeFromWorld = glm::transpose(glm::mat3(g.worldFromProbe));
  const glm::vec3 offset = glm::vec3(s.positionWorld - s.eyeWorld) - glm::vec3(g.originWorld - s.eyeWorld);
  const glm::vec3 from = g.rotated ? probeFromWorld * offset : offset;
  const glm::vec3 along = g.rotated ? probeFromWorld * toLight : toLight;
  const float maxLevel = probe.coverage != nullptr ? probe.coverage->maxLevel() : 0.0f;
  const auto own = static_cast<float>(light.levelsPerUnit);
  const float perUnit = light.shadowLevel == ShadowLevel::Size ? -1.0f
                        : own > 0.0f                           ? own
                                                               : levelsPerUnit(g.boxMin, g.boxMax, maxLevel);
  const auto faceSize = static_cast<float>(probe.coverage != nullptr ? probe.coverage->faceSize() : 1);
  const shading::CoverageLook look = shading::coverageLook(from, along, g.boxMin, g.boxMax, tangent, perUnit, faceSize);
  shadow.distance = look.distance;
  shadow.hitWorld = g.originWorld + g.worldFromProbe * glm::dvec3(look.hit);
  if (probe.coverage == nullptr) return shadow;
  shadow.level = std::clamp(look.level, 0.0f, maxLevel);
  const glm::vec3 inMap = g.mapTurned ? glm::mat3(g.mapFromProbe) * look.hit : look.hit;
  shadow.through = glm::vec3(probe.coverage->fetch(shading::lookupDirection(inMap), shadow.level));
  return shadow;
}

/// Unit direction and distance; 1 for a directional light.
std::pair<glm::vec3, float> wayTo(const Light& light, const glm::dvec3& positionWorld) {
  if (light.type == LightType::Directional) return {glm::vec3(-glm::normalize(light.direction)), 1.0f};
  const glm::vec3 to(light.position - positionWorld);
  const float distance = glm::length(to);
  return {to / std::max(distance, 1.0e-18f), distance};
}

/// The shares of the draw's probes and the sky in the pixel.
ProbeShares sharesAt(const ExplainInput& in) {
  const SurfacePoint& s = in.surface;
  std::vector<float> influences;
  std::vector<int> groups;
  for (const ExplainedProbe& probe : in.probes) {
    const ProbeGeometry& g = probe.geometry;
    const glm::vec3 offset = glm::vec3(s.positionWorld - s.eyeWorld) - glm::vec3(g.originWorld - s.eyeWorld);
    const glm::vec3 p = g.rotated ? glm::transpose(glm::mat3(g.worldFromProbe)) * offset : offset;
    influences.push_back(shading::influenceWeight(p, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax));
    groups.push_back(probe.group);
  }
  ProbeShares shares =
      in.shares.empty() ? shareOut(influences, groups, in.onlyProbes) : ProbeShares{in.shares, in.skyShare};
  if (!in.weights) shares = {std::vector<float>(in.probes.size(), 1.0f), 0.0f};
  return shares;
}

}  // namespace

ShadowRay shadowRay(const ExplainedProbe& probe, const glm::dvec3& positionWorld, const glm::dvec3& eyeWorld,
                    const Light& light) {
  SurfacePoint surface;
  surface.positionWorld = positionWorld;
  surface.eyeWorld = eyeWorld;
  const auto [toLight, distance] = wayTo(light, positionWorld);
  return {toLight, probeShadow(probe, surface, toLight, lightSize(light).tangentAt(distance), light)};
}

float movingShadowAt(const MovingMap& map, const glm::dvec3& positionWorld) {
  const glm::dvec4 clip = map.mapFromWorld * glm::dvec4(positionWorld, 1.0);
  if (clip.w <= 0.0) return 1.0f;
  const glm::dvec3 at = glm::dvec3(clip) / clip.w;
  if (at.x < 0.0 || at.x > 1.0 || at.y < 0.0 || at.y > 1.0 || at.z < 0.0) return 1.0f;
  const auto reference = static_cast<float>(std::min(at.z, 1.0));
  const auto lit = [&](int column, int row) {
    const int c = std::clamp(column, 0, map.size - 1), r = std::clamp(row, 0, map.size - 1);
    const auto texel = static_cast<std::size_t>(r) * static_cast<std::size_t>(map.size) + static_cast<std::size_t>(c);
    return reference <= (*map.depth)[texel] ? 1.0f : 0.0f;
  };
  float sum = 0.0f;
  for (int i = 0; i < 9; ++i) {
    const double x = (at.x + (i % 3 - 1) * map.apart.x) * map.size - 0.5,
                 y = (at.y + (i / 3 - 1) * map.apart.y) * map.size - 0.5;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const auto a = static_cast<float>(x - column), b = static_cast<float>(y - row);
    sum += (1.0f - b) * ((1.0f - a) * lit(column, row) + a * lit(column + 1, row)) +
           b * ((1.0f - a) * lit(column, row + 1) + a * lit(column + 1, row + 1));
  }
  return sum / 9.0f;
}

float seenShare(const ExplainedProbe& probe, const SurfacePoint& surface, int channel) {
  if (channel < 0 || !probe.sight) return channel == kSeenByNone ? 0.0f : 1.0f;
  const ProbeGeometry& g = probe.geometry;
  const glm::mat3 probeFromWorld = glm::transpose(glm::mat3(g.worldFromProbe));
  const glm::vec3 offset =
      glm::vec3(surface.positionWorld - surface.eyeWorld) - glm::vec3(g.originWorld - surface.eyeWorld);
  const glm::vec3 place = shading::sightPlace(sightShape(*probe.sight, g), g.rotated ? probeFromWorld * offset : offset,
                                              g.rotated ? probeFromWorld * surface.normalWorld : surface.normalWorld);
  const SightLattice& lattice = probe.sight->lattice;
  return shading::sightShare(lattice.fetchSight(place, channel / 4)[channel % 4], lattice.fetchSight(place, 0).x);
}

float lightSeen(const ExplainInput& in, int light) {
  if (std::find(in.sightLights.begin(), in.sightLights.end(), light) == in.sightLights.end()) return 1.0f;
  const ProbeShares shares = sharesAt(in);
  float seen = shares.sky;
  for (std::size_t i = 0; i < in.probes.size(); ++i) {
    const auto& sight = in.probes[i].sight;
    const int channel = sight ? sight->channelOfSource(static_cast<std::size_t>(light)) : kSeenByAll;
    seen += shares.probes[i] * seenShare(in.probes[i], in.surface, channel);
  }
  return seen;
}

float sunSeen(const ExplainInput& in, int light) {
  float seen = 1.0f;
  for (const MovingMap& map : in.sunMaps) {
    if (map.light != light) continue;
    seen *= movingShadowAt(map, in.surface.positionWorld + map.off * glm::dvec3(in.surface.normalWorld));
  }
  return seen;
}

std::vector<LightShadow> explainShadows(const ExplainInput& in) {
  const SurfacePoint& s = in.surface;
  const ProbeShares shares = sharesAt(in);
  std::vector<LightShadow> result;
  for (const int index : in.shadowLights) {
    const Light& light = in.lights[static_cast<std::size_t>(index)];
    LightShadow shadow;
    shadow.light = index;
    const auto [toLight, distance] = wayTo(light, s.positionWorld);
    const float tangent = lightSize(light).tangentAt(distance);
    shadow.toLight = toLight;
    if (glm::dot(s.normalWorld, toLight) <= 0.0f) {
      shadow.facesAway = true;
      result.push_back(shadow);
      continue;
    }
    glm::vec3 through(shares.sky);
    for (std::size_t i = 0; i < in.probes.size(); ++i) {
      if (shares.probes[i] <= 1.0e-5f) continue;
      if ((in.probes[i].shadowLights >> index & 1u) == 0) {
        through += glm::vec3(shares.probes[i]);
        continue;
      }
      shadow.probes.push_back(probeShadow(in.probes[i], s, toLight, tangent, light));
      through += shares.probes[i] * shadow.probes.back().through;
    }
    for (const MovingMap& map : in.movingMaps) {
      if (map.light == index) shadow.moving = movingShadowAt(map, s.positionWorld);
    }
    shadow.through = shadow.moving.value_or(1.0f) * through;
    result.push_back(shadow);
  }
  return result;
}

}  // namespace boxprobe
