#include "filters/reference/light/reflecting_layers.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/math/shared/finish_math.h"
#include "filters/reference/light/lobe_albedo.h"
#include "filters/reference/light/sheen_light.h"

namespace boxprobe {

namespace {

bool hasNormal(const glm::vec3& n) {
  return glm::dot(n, n) > 0.25f;
}

// Schlick's grazing term.
double grazing(double cosine) {
  const double rest = 1.0 - std::min(cosine, 1.0), square = rest * rest;
  return square * square * rest;
}

glm::dvec3 scattered(const ReflectingLayer& layer, const glm::vec3& view, Energy energy) {
  if (energy == Energy::Single) return glm::dvec3(1.0);
  return multipleScatteringFactor(glm::dvec3(layer.fresnel.f0), glm::dot(layer.normalWorld, glm::dvec3(view)),
                                  layer.roughness);
}

}  // namespace

VisibleNormalLobe ReflectingLayer::lobe(const glm::dvec3& view) const {
  const double alpha = roughness * roughness;
  if (anisotropy <= 0.0) return {normalWorld, view, alpha};
  const double along = glm::mix(alpha, 1.0, anisotropy * anisotropy);
  return {normalWorld, glm::normalize(acrossWorld), view, along, alpha};
}

glm::dvec3 ReflectingLayer::normalReflectance(double cosine) const {
  const glm::vec3& f0 = fresnel.f0;
  if (film <= 0.0) return glm::dvec3(f0);
  const auto c = static_cast<float>(std::clamp(cosine, 0.0, 1.0));
  const glm::vec3 colored = shading::filmNormalReflectance(
      shading::filmReflectance(f0, static_cast<float>(filmIor), static_cast<float>(filmThickness), c), c);
  return glm::mix(glm::dvec3(f0), glm::dvec3(colored), film);
}

glm::dvec3 ReflectingLayer::reflectance(double hDotV) const {
  const double edge = grazing(hDotV);
  const double passes = 1.0 - coatStrength * (coatF0 + (1.0 - coatF0) * edge);
  return factor * passes * glm::mix(normalReflectance(hDotV), glm::dvec3(fresnel.f90), edge);
}

glm::dvec3 ReflectingLayer::albedo(double nDotV) const {
  const glm::dvec2 of = lobeAlbedo(nDotV, roughness);
  const double passes = 1.0 - coatStrength * (coatF0 + (1.0 - coatF0) * grazing(nDotV));
  return factor * passes * (of.x * normalReflectance(nDotV) + of.y * glm::dvec3(fresnel.f90));
}

FresnelEnds fresnelEnds(const SurfacePoint& s) {
  const glm::vec3 f0 = glm::mix(s.finish ? s.finish->f0 : glm::vec3(s.baseF0), s.albedo, s.metallic);
  const float own = std::clamp(glm::dot(f0, glm::vec3(50.0f * 0.33f)), 0.0f, 1.0f);
  const float edge = s.finish && s.finish->tinted ? s.finish->edge : own;
  return {f0, glm::mix(glm::vec3(edge), glm::vec3(1.0f), s.metallic)};
}

std::vector<ReflectingLayer> reflectingLayers(const SurfacePoint& s, Energy energy) {
  std::vector<ReflectingLayer> layers;
  if (!hasNormal(s.normalWorld)) return layers;
  const bool coated = s.coatStrength > 0.0f && hasNormal(s.coatNormalWorld);
  ReflectingLayer base{glm::normalize(glm::dvec3(s.normalWorld)), s.roughness, fresnelEnds(s)};
  const glm::vec3 most = glm::max(base.fresnel.f0, base.fresnel.f90);
  if (s.occlusion * std::max({most.x, most.y, most.z}) > 0.0f) {
    base.factor = static_cast<double>(s.occlusion) * sheenPasses(s) * scattered(base, s.viewWorld, energy);
    if (s.finish) {
      base.film = s.finish->iridescence;
      base.filmIor = s.finish->filmIor;
      base.filmThickness = s.finish->filmThickness;
      base.anisotropy = s.finish->anisotropy;
      base.acrossWorld = s.finish->acrossWorld;
    }
    if (coated) {
      base.coatStrength = s.coatStrength;
      base.coatF0 = s.coatF0;
    }
    layers.push_back(base);
  }
  if (coated && s.occlusion > 0.0f) {
    ReflectingLayer coat{
        glm::normalize(glm::dvec3(s.coatNormalWorld)), s.coatRoughness, {glm::vec3(s.coatF0), glm::vec3(1.0f)}};
    coat.factor = static_cast<double>(s.occlusion * s.coatStrength) * scattered(coat, s.viewWorld, energy);
    layers.push_back(coat);
  }
  return layers;
}

}  // namespace boxprobe
