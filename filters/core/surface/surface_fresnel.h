// What a surface reflects straight on and at a flat angle, as the spliced shader has it: metalness, tint, thin films.
// Called by explanations and by the light sources on a surface.
#pragma once

#include <glm/vec3.hpp>

#include "filters/core/surface/surface_point.h"

namespace boxprobe {

/// The two ends of Schlick's curve.
struct SurfaceFresnel {
  glm::vec3 f0{0.04f}, f90{1.0f};
};

/// `nDotV`: cosine between normal and view, at which a thin film has its colour.
SurfaceFresnel surfaceFresnel(const SurfacePoint& surface, float nDotV);

/// What of the light the sheen leaves to what lies under it: 1 without one.
float passesSheen(const SurfacePoint& surface, float nDotV);

}  // namespace boxprobe
