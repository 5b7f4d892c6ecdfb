// The layers of a surface that reflect: the base and, above it, a clear coat, each with a lobe and the reflectance of a
// microfacet. Both references evaluate these per ray, without any table of the renderer's.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/core/surface/surface_point.h"
#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {

/// Reflectance at normal incidence and at grazing angles, as in the shader.
struct FresnelEnds {
  glm::vec3 f0{0.04f}, f90{1.0f};
};
FresnelEnds fresnelEnds(const SurfacePoint& surface);

struct ReflectingLayer {
  glm::dvec3 normalWorld{0.0};
  double roughness = 0.0;            ///< perceptual
  FresnelEnds fresnel;               ///< without a film
  double film = 0.0, filmIor = 1.3;  ///< of a thin film on it: coverage
  double filmThickness = 0.0;        ///< nanometres
  double anisotropy = 0.0;           ///< 0: isotropic
  glm::dvec3 acrossWorld{0.0};       ///< unit, of a brushed surface
  glm::dvec3 factor{1.0};            ///< occlusion, the coat's strength, transmittance of sheen, multiple scattering
  double coatStrength = 0.0, coatF0 = 0.0;  ///< of the coat above it, which transmits the rest

  /// The lobe seen from `view` (unit).
  VisibleNormalLobe lobe(const glm::dvec3& view) const;
  /// The reflectance of a microfacet at this cosine to the view: Schlick's Fresnel, times all factors.
  glm::dvec3 reflectance(double hDotV) const;
  glm::dvec3 normalReflectance(double cosine) const;
  /// The albedo at `nDotV`: the mean reflectance of all microfacets.
  glm::dvec3 albedo(double nDotV) const;
};

/// Empty for a surface that reflects nothing or has no normal.
std::vector<ReflectingLayer> reflectingLayers(const SurfacePoint& surface, Energy energy);

}  // namespace boxprobe
