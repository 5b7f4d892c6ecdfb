// Recomputes the glass in a pixel as shaders/gpu/glass.glsl does.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "filters/explain/explanation.h"
#include "filters/math/shared/refraction.h"

namespace boxprobe {

/// A glass object as the surface inspector reads it.
struct ExplainedGlass {
  std::string form;
  shading::GlassObject object;  ///< positions relative to the eye, world axes
  const shading::ShellSampler* shell = nullptr;
  float transmission = 1.0f;
  float attenuationDistance = 0.0f;
  glm::vec3 attenuationColor{1.0f};
  float straightAngle = 0.02f;
  float behind = 0.0f;
};

/// Light of probes and sky along a direction from a point, for a roughness.
struct GatheredGlass {
  glm::vec3 specular{0.0f};
  int lookups = 0;
  float brightestTexel = 0.0f;
  Phrase sources;
};
using GatherGlass =
    std::function<GatheredGlass(const glm::dvec3& positionWorld, const glm::vec3& direction, float roughness)>;

/// Where the view continues and, from inside, what it mirrors: computed before any light is gathered.
shading::GlassView lookThrough(const ExplainedGlass& glass, const SurfacePoint& surface);

/// `reflected`: the factor of the reflection, which reduces the transmitted light.
GlassExplanation explainGlass(const ExplainedGlass& glass, const SurfacePoint& surface, const shading::GlassView& seen,
                              float reflected, const GatherGlass& gather);

/// Transmittance of what is mirrored inside.
glm::vec3 mirrorTransmittance(const ExplainedGlass& glass, const SurfacePoint& surface, const shading::GlassView& seen);

}  // namespace boxprobe
