// Light that a draw's probes, the sky and a planar mirror's picture bring to a point: shared out and summed as
// bpGatherLight does. Called by explainPixel for the surface, its coat and what glass is looked through.
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
  /// That over what the surface reflects at all: beside the mean light of its lobe.
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

/// For a normal and a perceptual roughness at the input's surface; `reflectance`: its own there.
GatheredLight gatherLight(const ExplainInput& in, const glm::vec3& normal, float roughness,
                          const Reflectance& reflectance);

/// The same from another place, round about a direction: what glass is looked through, and mirrors within.
GatheredLight gatherAlong(const ExplainInput& in, const glm::dvec3& positionWorld, const glm::vec3& direction,
                          float roughness);

/// That as glass has it, with the names of what it comes from.
GatheredGlass gatherForGlass(const ExplainInput& in, const glm::dvec3& positionWorld, const glm::vec3& direction,
                             float roughness);

}  // namespace boxprobe
