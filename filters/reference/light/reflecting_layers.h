// What of a surface reflects its surroundings: the base and, over it, a clear coat, each a lobe and the split-sum
// factor that VTK 9.1's shader multiplies its reflection with. Called by both references, so that all they differ in
// from the picture is what the lobe sees.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "filters/core/surface/surface_point.h"
#include "filters/math/sampling/brdf_table.h"

namespace boxprobe {

/// Fresnel's ends at normal incidence and at the edge, as the shader has them.
struct FresnelEnds {
  glm::vec3 f0{0.04f}, f90{1.0f};
};
FresnelEnds fresnelEnds(const SurfacePoint& surface);

struct ReflectingLayer {
  glm::dvec3 normalWorld{0.0};
  double roughness = 0.0;  ///< perceptual
  FresnelEnds fresnel;
  glm::dvec3 factor{0.0};  ///< of the mean radiance over the lobe: split sum, ambient occlusion, the coat's strength
};

/// None for a surface that reflects nothing or has no normal.
std::vector<ReflectingLayer> reflectingLayers(const SurfacePoint& surface, const BrdfTable& brdf);

}  // namespace boxprobe
