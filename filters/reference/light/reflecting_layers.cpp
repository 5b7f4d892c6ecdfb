// The terms are those of the shader, as filters/explain has them, which is held to the graphics side pixel by pixel.
#include "filters/reference/light/reflecting_layers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

float clampedCosine(const glm::vec3& a, const glm::vec3& b) {
  return std::clamp(glm::dot(a, b), 1.0e-5f, 1.0f);
}

bool hasNormal(const glm::vec3& n) {
  return glm::dot(n, n) > 0.25f;
}

}  // namespace

FresnelEnds fresnelEnds(const SurfacePoint& s) {
  const glm::vec3 f0 = glm::mix(glm::vec3(s.baseF0), s.albedo, s.metallic);
  const float edge = std::clamp(glm::dot(f0, glm::vec3(50.0f * 0.33f)), 0.0f, 1.0f);
  return {f0, glm::mix(glm::vec3(edge), glm::vec3(1.0f), s.metallic)};
}

std::vector<ReflectingLayer> reflectingLayers(const SurfacePoint& s, const BrdfTable& brdf) {
  std::vector<ReflectingLayer> layers;
  if (!hasNormal(s.normalWorld)) return layers;
  const FresnelEnds ends = fresnelEnds(s);
  const glm::vec2 base = sampleBrdf(brdf, clampedCosine(s.normalWorld, s.viewWorld), s.roughness);
  const glm::vec3 factor = s.occlusion * (ends.f0 * base.x + ends.f90 * base.y);
  if (std::max({factor.x, factor.y, factor.z}) > 0.0f) {
    layers.push_back({glm::dvec3(s.normalWorld), s.roughness, ends, glm::dvec3(factor)});
  }
  if (s.coatStrength > 0.0f && hasNormal(s.coatNormalWorld)) {
    const float nDotV = clampedCosine(s.coatNormalWorld, s.viewWorld);
    const glm::vec2 coat = sampleBrdf(brdf, nDotV, s.coatRoughness);
    const float fresnel = s.coatF0 + (1.0f - s.coatF0) * std::pow(1.0f - nDotV, 5.0f);
    const double strength = s.occlusion * (s.coatF0 * coat.x + coat.y) * fresnel * s.coatStrength;
    layers.push_back(
        {glm::dvec3(s.coatNormalWorld), s.coatRoughness, {glm::vec3(s.coatF0), glm::vec3(1.0f)}, glm::dvec3(strength)});
  }
  return layers;
}

}  // namespace boxprobe
