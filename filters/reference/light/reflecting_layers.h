// What of a surface reflects its surroundings: the base and, over it, a clear coat, each a lobe and what one of its
// microfacets reflects. Called by both references, which evaluate it ray by ray: no table of the renderer's stands
// between them and the light.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/core/surface/surface_point.h"
#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {

/// Fresnel's ends at normal incidence and at the edge, as the shader has them.
struct FresnelEnds {
  glm::vec3 f0{0.04f}, f90{1.0f};
};
FresnelEnds fresnelEnds(const SurfacePoint& surface);

struct ReflectingLayer {
  glm::dvec3 normalWorld{0.0};
  double roughness = 0.0;                   ///< perceptual
  FresnelEnds fresnel;                      ///< without a film
  double film = 0.0, filmIor = 1.3;         ///< of a thin film on it: its share
  double filmThickness = 0.0;               ///< nanometres
  double anisotropy = 0.0;                  ///< 0: as rough along every direction
  glm::dvec3 acrossWorld{0.0};              ///< unit, where it is brushed
  glm::dvec3 factor{1.0};                   ///< occlusion, the coat's strength, what sheen leaves, multiple scattering
  double coatStrength = 0.0, coatF0 = 0.0;  ///< of the coat above it, which leaves the rest to it

  /// Its half vectors seen from `view` (unit).
  VisibleNormalLobe lobe(const glm::dvec3& view) const;
  /// Of a microfacet that the view meets at this cosine: Schlick's Fresnel, times all that comes on top.
  glm::dvec3 reflectance(double hDotV) const;
  glm::dvec3 normalReflectance(double cosine) const;
  /// Of even light, seen at `nDotV`: what the mean of all microfacets' reflectances is.
  glm::dvec3 albedo(double nDotV) const;
};

/// None for a surface that reflects nothing or has no normal.
std::vector<ReflectingLayer> reflectingLayers(const SurfacePoint& surface, Energy energy);

}  // namespace boxprobe
