#include "filters/explain/explain_pixel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/surface/direct_light.h"
#include "filters/core/surface/surface_fresnel.h"
#include "filters/explain/explain_shadow.h"
#include "filters/explain/explanation_notes.h"
#include "filters/explain/gather_light.h"
#include "filters/math/sampling/brdf_table.h"
#include "filters/math/shared/finish_math.h"

namespace boxprobe {

namespace {

glm::vec3 scattered(const ExplainInput& in, const glm::vec3& f0, const glm::vec2& brdf) {
  return in.energy == Energy::Multiple ? shading::multipleScattering(f0, brdf) : glm::vec3(1.0f);
}

float coatNDotV(const SurfacePoint& s) {
  return std::clamp(glm::dot(s.coatNormalWorld, s.viewWorld), 1.0e-5f, 1.0f);
}

/// Transmittance of the coat; 1 without one.
float coatTransmittance(const SurfacePoint& s) {
  return s.coatStrength > 0.0f ? shading::coatPasses(s.coatStrength, s.coatF0, coatNDotV(s)) : 1.0f;
}

/// Factor of the base's reflection besides the split sum: multiple scattering, and the coat's transmittance.
glm::vec3 baseFactor(const Explanation& e, const ExplainInput& in) {
  return coatTransmittance(in.surface) * passesSheen(in.surface, e.nDotV) * scattered(in, e.f0, e.brdf);
}

/// Glass reflects less by what it transmits; the transmitted light is sampled along the refracted view.
void addGlass(Explanation& e, const ExplainInput& in, const shading::GlassView& through,
              const glm::vec3& reflectedLight, const glm::vec3& edge) {
  const SurfacePoint& s = in.surface;
  const float reflected = through.reflectance >= 1.0f ? 1.0f : through.reflectance * (e.brdf.x + e.brdf.y);
  const glm::vec3 factor =
      glm::mix(reflected * mirrorTransmittance(*in.glass, s, through), e.f0 * e.brdf.x + edge * e.brdf.y, s.metallic);
  e.specularFactor = s.occlusion * factor * baseFactor(e, in);
  e.specular = reflectedLight * e.specularFactor;
  e.diffuse *= 1.0f - in.glass->transmission;
  e.glass = explainGlass(*in.glass, s, through, reflected,
                         [&in](const glm::dvec3& position, const glm::vec3& direction, float roughness) {
                           return gatherForGlass(in, position, direction, roughness);
                         });
  e.glass->passed *= s.occlusion;
}

/// The clear coat's reflection, along its own normal.
void addCoat(Explanation& e, const ExplainInput& in) {
  const SurfacePoint& s = in.surface;
  const float nDotV = coatNDotV(s);
  const GatheredLight coat = gatherLight(in, s.coatNormalWorld, s.coatRoughness,
                                         {shading::meanFresnel(glm::vec3(s.coatF0), glm::vec3(1.0f), nDotV), s.coatF0});
  const glm::vec2 brdf = splitSum(nDotV, s.coatRoughness);
  const glm::vec3 light = coat.specular + coat.lampsMean(glm::vec3(s.coatF0), glm::vec3(1.0f), brdf);
  e.coat =
      s.occlusion * light * (s.coatF0 * brdf.x + brdf.y) * s.coatStrength * scattered(in, glm::vec3(s.coatF0), brdf);
  e.lookupCount += coat.lookups;
  e.brightestTexel = std::max(e.brightestTexel, coat.brightestTexel);
}

/// Light of probes and sky on a brushed surface: one lookup along the normal that stands for its streak.
GatheredLight gatherForBase(const Explanation& e, const ExplainInput& in, const glm::vec3& edge) {
  const SurfacePoint& s = in.surface;
  const Reflectance reflectance{shading::meanFresnel(e.f0, edge, e.nDotV), shading::relativeF0(e.f0, edge)};
  GatheredLight light = gatherLight(in, e.lookupNormal, s.roughness, reflectance);
  if (e.lookupNormal != s.normalWorld) {
    light.irradiance = gatherLight(in, s.normalWorld, s.roughness, reflectance).irradiance;
  }
  return light;
}

/// Light from the whole hemisphere: the base's diffuse light, and the sheen above it.
void addDiffuse(Explanation& e, const SurfacePoint& s, const glm::vec3& irradiance) {
  const float under = passesSheen(s, e.nDotV), passes = s.occlusion * coatTransmittance(s);
  e.diffuse = passes * under * (1.0f - e.f0) * (1.0f - s.metallic) * irradiance * s.albedo;
  if (!s.finish || !s.finish->hasSheen()) return;
  e.sheen = passes * s.finish->sheenColor * shading::sheenAlbedo(e.nDotV, s.finish->sheenRoughness) * irradiance;
}

/// The position of the probe with the largest weight; -1 where none has any.
int dominantProbe(const std::vector<ProbeExplanation>& probes) {
  int dominant = -1;
  float largest = 0.0f;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (probes[i].weight <= largest) continue;
    largest = probes[i].weight;
    dominant = static_cast<int>(i);
  }
  return dominant;
}

/// `edge`: the reflectance at grazing incidence.
void lightByProbes(Explanation& e, const ExplainInput& in, const glm::vec3& edge) {
  const SurfacePoint& s = in.surface;
  const std::optional<shading::GlassView> through =
      in.glass ? std::optional<shading::GlassView>(lookThrough(*in.glass, s)) : std::nullopt;
  GatheredLight light = through && through->followed
                            ? gatherAlong(in, s.eyeWorld + glm::dvec3(through->mirrored.position),
                                          through->mirrored.direction, std::sqrt(through->mirrored.alpha))
                            : gatherForBase(e, in, edge);
  e.specularFactor = s.occlusion * (e.f0 * e.brdf.x + edge * e.brdf.y) * baseFactor(e, in);
  e.specular = (light.specular + light.lampsMean(e.f0, edge, e.brdf)) * e.specularFactor;
  if (in.diffuse) e.irradiance = light.irradiance;
  addDiffuse(e, s, light.irradiance);
  if (through) addGlass(e, in, *through, light.specular, edge);
  e.probes = std::move(light.probes);
  e.skyWeight = light.skyWeight;
  e.mirror = light.mirror;
  e.skyLevel = light.skyLevel;
  e.skyValue = light.skyValue;
  e.lookupCount = light.lookups;
  for (const LightShadow& shadow : e.shadows) e.lookupCount += static_cast<int>(shadow.probes.size());
  e.brightestTexel = light.brightestTexel;
  if (s.coatStrength > 0.0f) addCoat(e, in);
  if (e.glass) {
    e.lookupCount += e.glass->lookups;
    e.brightestTexel = std::max(e.brightestTexel, e.glass->brightestTexel);
  }
  e.dominant = dominantProbe(e.probes);
  addNotes(e, in);
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
    e.notes.push_back(Phrase::tr("The material is unlit: it shows its colour, no light and no probe."));
    return e;
  }
  if (glm::dot(s.normalWorld, s.normalWorld) < 0.25f) {
    e.notes.push_back(Phrase::tr("The surface has no normal here, so there is no reflected ray to project."));
    return e;
  }
  e.lookupNormal = s.normalWorld;
  if (s.finish && s.finish->anisotropy > 0.0f) {
    e.lookupNormal = shading::anisotropicNormal(s.normalWorld, s.viewWorld, s.finish->acrossWorld, s.roughness,
                                                s.finish->anisotropy);
  }
  e.reflectionWorld = shading::reflectedView(e.lookupNormal, s.viewWorld);
  const float facing = glm::dot(s.normalWorld, s.viewWorld);
  if (facing <= 0.0f) {
    e.notes.push_back(Phrase::tr(
        "The shading normal points away from the eye. A ray reflected about it would start below the surface, "
        "so it goes straight on."));
  }
  e.nDotV = std::clamp(facing, 1.0e-5f, 1.0f);
  const SurfaceFresnel ends = surfaceFresnel(s, e.nDotV);
  e.f0 = ends.f0;
  const glm::vec3 edge = ends.f90;
  std::vector<glm::vec3> arrives(in.lights.size(), glm::vec3(1.0f));
  if (in.lighting == ExplainInput::Lighting::Probes) e.shadows = explainShadows(in);
  for (const LightShadow& shadow : e.shadows) arrives[static_cast<std::size_t>(shadow.light)] = shadow.through;
  for (const MovingMap& map : in.sunMaps) arrives[static_cast<std::size_t>(map.light)] *= sunSeen(in, map.light);
  for (const int light : in.sightLights) arrives[static_cast<std::size_t>(light)] *= lightSeen(in, light);
  e.brdf = splitSum(e.nDotV, s.roughness);
  Scattering scattering{scattered(in, e.f0, e.brdf), glm::vec3(1.0f)};
  if (s.coatStrength > 0.0f) {
    const glm::vec3 coatF0(s.coatF0);
    scattering.coat = scattered(in, coatF0, splitSum(coatNDotV(s), s.coatRoughness));
  }
  e.direct = directLight(s, e.f0, edge, in.lights, &arrives, scattering);

  if (in.lighting == ExplainInput::Lighting::Probes) lightByProbes(e, in, edge);
  e.color = e.direct + e.diffuse + e.sheen + e.specular + e.coat + e.emissive;
  if (e.glass) e.color += e.glass->light();
  return e;
}

}  // namespace boxprobe
