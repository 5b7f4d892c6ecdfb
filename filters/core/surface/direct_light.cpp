// The terms and clamps are those of VTK 9.1.0's vtkPBRFunctions.glsl with the repairs of
// filters/vtk/surface/vtk_pbr_splice.cpp, the masking term and a guard against 0/0: the result must equal what is on
// screen.
#include "filters/core/surface/direct_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/surface/surface_fresnel.h"
#include "filters/math/shared/finish_math.h"

namespace boxprobe {

namespace {

constexpr float kReciprocalPi = 0.31830988618f;

float clampedCosine(const glm::vec3& a, const glm::vec3& b) {
  return std::clamp(glm::dot(a, b), 1.0e-5f, 1.0f);
}

struct Lobe {
  glm::vec3 specular;
  glm::vec3 fresnel;
};

Lobe isotropicLobe(float nDotH, float nDotV, float nDotL, float hDotL, float roughness, const glm::vec3& f0,
                   const glm::vec3& f90) {
  const float alpha = roughness * roughness, a2 = alpha * alpha;
  const float d = std::max((nDotH * a2 - nDotH) * nDotH + 1.0f, std::max(a2, 1.0e-12f));
  const float distribution = a2 / (3.14159265359f * d * d);
  const float masking = 0.5f / (nDotL * std::sqrt(a2 + nDotV * (nDotV - a2 * nDotV)) +
                                nDotV * std::sqrt(a2 + nDotL * (nDotL - a2 * nDotL)));
  const glm::vec3 fresnel = f0 + (f90 - f0) * std::pow(1.0f - hDotL, 5.0f);
  return {distribution * masking * fresnel, fresnel};
}

/// The base lobe of brushed surfaces (shaders/gpu/finish.glsl).
Lobe baseLobe(const SurfacePoint& s, const glm::vec3& h, const glm::vec3& l, const Lobe& isotropic) {
  if (!s.finish || s.finish->anisotropy <= 0.0f) return isotropic;
  const glm::vec3 &n = s.normalWorld, &across = s.finish->acrossWorld, along = glm::cross(across, n);
  const auto within = [&](const glm::vec3& d) {
    return glm::vec3(glm::dot(along, d), glm::dot(across, d), clampedCosine(n, d));
  };
  const glm::vec2 alpha = shading::anisotropicAlpha(s.roughness * s.roughness, s.finish->anisotropy);
  return {shading::anisotropicLobe(within(s.viewWorld), within(l), within(h), alpha) * isotropic.fresnel,
          isotropic.fresnel};
}

glm::vec3 sheenLobe(const SurfacePoint& s, float nDotH, float nDotV, float nDotL) {
  if (!s.finish || !s.finish->hasSheen()) return glm::vec3(0.0f);
  return s.finish->sheenColor * shading::sheenLobe(nDotH, nDotV, nDotL, s.finish->sheenRoughness);
}

}  // namespace

glm::vec3 directLight(const SurfacePoint& s, const glm::vec3& f0, const glm::vec3& f90,
                      const std::vector<Light>& lights, const std::vector<glm::vec3>* through,
                      const Scattering& scattering) {
  const glm::vec3 n = s.normalWorld, v = s.viewWorld;
  const float nDotV = clampedCosine(n, v), underSheen = passesSheen(s, nDotV);
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    glm::vec3 radiance = light.color * light.intensity;
    if (through != nullptr) radiance *= (*through)[i];
    glm::vec3 l;
    if (light.type != LightType::Directional) {
      const glm::vec3 to(light.position - s.positionWorld);
      const float distance = glm::length(to);
      l = to / std::max(distance, 1.0e-18f);  // at the lamp itself there is no direction
      radiance *= shading::distanceFalloff(distance, light.range > 0.0 ? static_cast<float>(1.0 / light.range) : 0.0f);
      if (light.type == LightType::Spot) {
        const auto cosine = [](double degrees) { return static_cast<float>(std::cos(glm::radians(degrees))); };
        radiance *= shading::coneFalloff(glm::dot(-l, glm::vec3(glm::normalize(light.direction))),
                                         cosine(light.outerConeDegrees), cosine(light.innerConeDegrees));
      }
    } else {
      l = glm::vec3(-glm::normalize(light.direction));
    }
    const glm::vec3 h = glm::normalize(v + l);
    const float hDotL = clampedCosine(h, l), nDotL = clampedCosine(n, l), nDotH = clampedCosine(n, h);
    Lobe base = baseLobe(s, h, l, isotropicLobe(nDotH, nDotV, nDotL, hDotL, s.roughness, f0, f90));
    glm::vec3 diffuse =
        (1.0f - s.transmission) * (1.0f - s.metallic) * (1.0f - base.fresnel) * s.albedo * kReciprocalPi;
    diffuse = diffuse * underSheen + sheenLobe(s, nDotH, nDotV, nDotL);
    base.specular *= underSheen;
    if (s.coatStrength > 0.0f) {
      const glm::vec3 coatN = s.coatNormalWorld;
      const float coatNDotL = clampedCosine(coatN, l);
      const Lobe coat = isotropicLobe(clampedCosine(coatN, h), clampedCosine(coatN, v), coatNDotL, hDotL,
                                      s.coatRoughness, glm::vec3(s.coatF0), glm::vec3(1.0f));
      const glm::vec3 under = 1.0f - coat.fresnel * s.coatStrength;
      sum += scattering.coat * coat.specular * radiance * coatNDotL * s.coatStrength;
      base.specular *= under;
      diffuse *= under;
    }
    sum += radiance * (diffuse + scattering.base * base.specular) * nDotL;
  }
  return sum;
}

}  // namespace boxprobe
