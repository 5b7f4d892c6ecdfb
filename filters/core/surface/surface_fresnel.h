// Reflectance of a surface at normal incidence and at grazing angles, as in the spliced shader: metalness, tint, thin
// films.
#pragma once

#include <glm/vec3.hpp>

#include "filters/core/surface/surface_point.h"

namespace boxprobe {

/// The two ends of Schlick's curve.
struct SurfaceFresnel {
  glm::vec3 f0{0.04f}, f90{1.0f};
};

/// `nDotV`: cosine between normal and view, which determines the colour of a thin film.
SurfaceFresnel surfaceFresnel(const SurfacePoint& surface, float nDotV);

/// The fraction of light that passes the sheen to the layers below: 1 without sheen.
float passesSheen(const SurfacePoint& surface, float nDotV);

}  // namespace boxprobe
