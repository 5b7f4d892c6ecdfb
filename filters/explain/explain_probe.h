// What one probe contributes to a pixel: runs its technique again and records every lookup.
#pragma once

#include <glm/vec3.hpp>

#include "filters/explain/explain_input.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// The reflectance of a surface as techniques get it in ShadingPoint.
struct Reflectance {
  float fresnel = 1.0f;
  float f0 = 1.0f;
};

/// `surface` has the normal to use; `reflection` is the view mirrored in it, `reflectance` the surface's there. `sky`:
/// shown where an open probe saw nothing; null: none. The weight stays 0.
ProbeExplanation explainProbe(const ExplainedProbe& probe, const SurfacePoint& surface, const glm::vec3& reflection,
                              float roughness, const Reflectance& reflectance, const BakedMaps* sky);

/// Irradiance over pi of a map at `normal`.
glm::vec3 irradianceAt(const glm::vec3& normal, const ShCoefficients& coefficients);

}  // namespace boxprobe
