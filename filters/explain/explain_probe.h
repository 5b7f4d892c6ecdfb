// What one probe gives to a pixel: its technique run once more, every fetch recorded. Called where a pixel's light is
// gathered; knows nothing of the probe's share.
#pragma once

#include <glm/vec3.hpp>

#include "filters/explain/explain_input.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// What techniques know of a surface's reflectance, as ShadingPoint has it.
struct Reflectance {
  float fresnel = 1.0f;
  float f0 = 1.0f;
};

/// `surface` with the normal that is looked up for; `reflection` is the view mirrored in it, `reflectance` the
/// surface's there. `sky`: what shows where an open probe saw nothing; null: none. The weight is left at 0.
ProbeExplanation explainProbe(const ExplainedProbe& probe, const SurfacePoint& surface, const glm::vec3& reflection,
                              float roughness, const Reflectance& reflectance, const BakedMaps* sky);

/// A map's light from all around `normal`, over pi.
glm::vec3 irradianceAt(const glm::vec3& normal, const ShCoefficients& coefficients);

}  // namespace boxprobe
