#include "filters/reference/light/capture_light.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "filters/core/surface/direct_light.h"
#include "filters/core/surface/surface_fresnel.h"
#include "filters/reference/light/lobe_albedo.h"
#include "filters/reference/light/reflecting_layers.h"
#include "filters/reference/light/sheen_light.h"

namespace boxprobe {

CaptureLight::CaptureLight(const Scene& scene, std::shared_ptr<const ImageRgbaF> skyImage)
    : sky_(scene.sky, std::move(skyImage), scene.skyRotationDegrees), energy_(scene.energy), lights_(scene.lights) {
  for (const Probe& probe : scene.probes) {
    probes_.push_back(
        {probeGeometry(probe, probe.origin), std::holds_alternative<ClearToOpen>(probe.clear), probes_.size()});
  }
  std::stable_sort(probes_.begin(), probes_.end(),
                   [](const auto& a, const auto& b) { return a.importance > b.importance; });
}

// The weights of shaders/gpu/probe_lighting.glsl while no probe has a map.
CaptureLight::Shares CaptureLight::shares(const glm::dvec3& position) const {
  Shares result{0.0f, 1.0f};
  for (std::size_t first = 0; first < probes_.size();) {
    std::size_t end = first;
    float sum = 0.0f, lit = 0.0f;
    for (; end < probes_.size() && probes_[end].importance == probes_[first].importance; ++end) {
      const LightingProbe& g = probes_[end];
      const glm::vec3 p(glm::transpose(g.worldFromProbe) * (position - g.originWorld));
      const float weight = shading::influenceWeight(p, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax);
      sum += weight;
      lit += g.open ? 0.0f : weight * g.intensity;
    }
    result.diffuse += result.sky * shading::groupScale(sum) * lit;
    result.sky = shading::remainingAfter(result.sky, sum);
    first = end;
  }
  result.diffuse += result.sky;
  return result;
}

glm::vec3 CaptureLight::irradiance(const SurfacePoint& s, const ProbesDiffuse& diffuse) const {
  glm::vec3 result(0.0f);
  float left = 1.0f;
  for (std::size_t first = 0; first < probes_.size();) {
    std::size_t end = first;
    float sum = 0.0f;
    glm::vec3 lit(0.0f);
    for (; end < probes_.size() && probes_[end].importance == probes_[first].importance; ++end) {
      const LightingProbe& g = probes_[end];
      if (g.index >= diffuse.probes.size() || !diffuse.probes[g.index]) continue;
      const glm::vec3 p(glm::transpose(g.worldFromProbe) * (s.positionWorld - g.originWorld));
      const float weight = shading::influenceWeight(p, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax);
      sum += weight;
      if (weight > 0.0f) {
        lit += weight * g.intensity * diffuseAt(*diffuse.probes[g.index], g, s.positionWorld, s.normalWorld);
      }
    }
    result += left * shading::groupScale(sum) * lit;
    left = shading::remainingAfter(left, sum);
    first = end;
  }
  return result + left * sky_.irradiance(s.normalWorld);
}

std::vector<glm::vec3> CaptureLight::seenThrough(const SurfacePoint& s, const ProbesDiffuse& diffuse,
                                                 const std::vector<glm::vec3>* through) const {
  std::vector<glm::vec3> seen = through != nullptr ? *through : std::vector<glm::vec3>();
  seen.resize(lights_.size(), glm::vec3(1.0f));
  std::vector<float> shares(lights_.size(), 0.0f);
  float left = 1.0f;
  for (std::size_t first = 0; first < probes_.size();) {
    std::size_t end = first;
    float sum = 0.0f;
    std::vector<float> here(lights_.size(), 0.0f);
    for (; end < probes_.size() && probes_[end].importance == probes_[first].importance; ++end) {
      const LightingProbe& g = probes_[end];
      const glm::vec3 p(glm::transpose(g.worldFromProbe) * (s.positionWorld - g.originWorld));
      const float weight = shading::influenceWeight(p, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax);
      sum += weight;
      const bool known = g.index < diffuse.probes.size() && diffuse.probes[g.index];
      const ProbeSight* sight = known ? diffuse.probes[g.index]->sight.get() : nullptr;
      for (std::size_t i = 0; i < lights_.size() && weight > 0.0f; ++i) {
        const int channel = sight != nullptr ? sight->channelOfSource(i) : kSeenByAll;
        here[i] += weight * seenAt(sight, channel, g, s.positionWorld, s.normalWorld);
      }
    }
    for (std::size_t i = 0; i < lights_.size(); ++i) shares[i] += left * shading::groupScale(sum) * here[i];
    left = shading::remainingAfter(left, sum);
    first = end;
  }
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    seen[i] *= diffuse.countedLights.count(i) != 0 ? 0.0f : shares[i] + left;
  }
  return seen;
}

std::optional<glm::dvec3> CaptureLight::capturedFrom(const glm::dvec3& position) const {
  const ProbeGeometry* best = nullptr;
  float most = 0.0f, left = 1.0f;
  for (std::size_t first = 0; first < probes_.size() && left > most;) {
    std::size_t end = first;
    float sum = 0.0f, largest = 0.0f;
    const ProbeGeometry* of = nullptr;
    for (; end < probes_.size() && probes_[end].importance == probes_[first].importance; ++end) {
      const ProbeGeometry& g = probes_[end];
      const glm::vec3 p(glm::transpose(g.worldFromProbe) * (position - g.originWorld));
      const float weight = shading::influenceWeight(p, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax);
      sum += weight;
      if (weight <= largest) continue;
      largest = weight;
      of = &g;
    }
    const float share = left * shading::groupScale(sum) * largest;
    if (share > most) {
      most = share;
      best = of;
    }
    left = shading::remainingAfter(left, sum);
    first = end;
  }
  if (best == nullptr) return std::nullopt;
  return best->originWorld;
}

Scattering CaptureLight::scattering(const SurfacePoint& s, const FresnelEnds& ends) const {
  Scattering result;
  if (energy_ == Energy::Single) return result;
  const auto back = [&](const glm::vec3& normal, float roughness, const glm::vec3& f0) {
    return glm::vec3(multipleScatteringFactor(glm::dvec3(f0), glm::dot(normal, s.viewWorld), roughness));
  };
  result.base = back(s.normalWorld, s.roughness, ends.f0);
  if (s.coatStrength > 0.0f) result.coat = back(s.coatNormalWorld, s.coatRoughness, glm::vec3(s.coatF0));
  return result;
}

glm::vec3 CaptureLight::unreflected(const SurfacePoint& s, bool unlit, const std::vector<glm::vec3>* through,
                                    const ProbesDiffuse* diffuse) const {
  if (unlit) return s.emissive;
  // As in the shader, with a film's colour at the eye: references do not judge light sources.
  const SurfaceFresnel lit = surfaceFresnel(s, std::clamp(glm::dot(s.normalWorld, s.viewWorld), 1.0e-5f, 1.0f));
  const FresnelEnds ends{lit.f0, lit.f90};
  glm::vec3 sum = s.emissive;
  std::vector<glm::vec3> seen;
  if (diffuse != nullptr && !lights_.empty()) {
    seen = seenThrough(s, *diffuse, through);
    through = &seen;
  }
  if (!lights_.empty()) sum += directLight(s, ends.f0, ends.f90, lights_, through, scattering(s, ends));
  if (s.metallic < 1.0f) {
    const float under = s.occlusion * static_cast<float>(sheenPasses(s));
    const glm::vec3 light =
        diffuse != nullptr ? irradiance(s, *diffuse) : shares(s.positionWorld).diffuse * sky_.irradiance(s.normalWorld);
    sum += under * (1.0f - ends.f0) * (1.0f - s.metallic) * s.albedo * light;
  }
  return sum;
}

glm::vec3 CaptureLight::captured(const SurfacePoint& s, bool unlit, const std::vector<glm::vec3>* through) const {
  glm::vec3 sum = unreflected(s, unlit, through);
  if (unlit) return sum;
  if (s.finish && s.finish->hasSheen()) {
    const double nDotV = std::max(static_cast<double>(glm::dot(s.normalWorld, s.viewWorld)), 0.0);
    const auto sent = static_cast<float>(sheenShare(nDotV, static_cast<double>(s.finish->sheenRoughness)));
    sum += s.occlusion * sent * s.finish->sheenColor * shares(s.positionWorld).diffuse * sky_.irradiance(s.normalWorld);
  }
  const float share = shares(s.positionWorld).sky;
  if (share <= 1.0e-5f) return sum;
  for (const ReflectingLayer& layer : reflectingLayers(s, energy_)) {
    const glm::vec3 normal(layer.normalWorld), direction = shading::reflectedView(normal, s.viewWorld);
    const double nDotV = std::max(static_cast<double>(glm::dot(normal, s.viewWorld)), 0.0);
    sum += share * glm::vec3(layer.albedo(nDotV)) * sky_.reflection(direction, static_cast<float>(layer.roughness));
  }
  return sum;
}

}  // namespace boxprobe
