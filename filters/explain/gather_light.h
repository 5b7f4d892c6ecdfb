// Light of a draw's probes, the sky and a planar mirror's picture at a point: shared and summed as in bpGatherLight.
#pragma once

#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "filters/explain/explain_input.h"
#include "filters/explain/explain_probe.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

struct GatheredLight {
  glm::vec3 specular{0.0f};
  glm::vec3 irradiance{0.0f};
  float lampsInMap = 0.0f;                  ///< mean of the colours
  glm::vec3 lampsF0{0.0f}, lampsF90{0.0f};  ///< reflected of lamps as shapes: F0 times the one plus F90 times the other
  /// That light divided by the surface's reflectance, to be added to the mean light of the lobe.
  glm::vec3 lampsMean(const glm::vec3& f0, const glm::vec3& f90, const glm::vec2& splitSum) const {
    return (f0 * lampsF0 + f90 * lampsF90) / glm::max(f0 * splitSum.x + f90 * splitSum.y, glm::vec3(1.0e-6f));
  }
  std::vector<ProbeExplanation> probes;
  float skyWeight = 0.0f, skyLevel = 0.0f;
  glm::vec3 skyValue{0.0f};
  int lookups = 0;
  float brightestTexel = 0.0f;
  std::optional<MirrorExplanation> mirror;
};

/// For a normal and a perceptual roughness at the input's surface; `reflectance`: the surface's there.
GatheredLight gatherLight(const ExplainInput& in, const glm::vec3& normal, float roughness,
                          const Reflectance& reflectance);

/// The same at another position, around a direction: the refracted view through glass, and reflections inside it.
GatheredLight gatherAlong(const ExplainInput& in, const glm::dvec3& positionWorld, const glm::vec3& direction,
                          float roughness);

/// The same for glass, with the names of the light's sources.
GatheredGlass gatherForGlass(const ExplainInput& in, const glm::dvec3& positionWorld, const glm::vec3& direction,
                             float roughness);

}  // namespace boxprobe
