// The glass part of a pixel's explanation: where the view continues, what is sampled, how much of it remains. Colours
// linear, lengths in scene units.
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "filters/core/base/phrase.h"

namespace boxprobe {

struct GlassExplanation {
  std::string form;   ///< "one-pass", "two-pass", "two-interface", "thin"
  bool back = false;  ///< the eye sees the inner side of the surface
  float ior = 1.5f;
  float eta = 1.0f;                ///< n1 / n2, n1 on the eye's side
  float reflectance = 0.0f;        ///< Fresnel's; 1: totally reflected
  bool followed = false;           ///< from inside: the reflection was followed to its exit
  glm::vec3 directionWorld{0.0f};  ///< the direction in which probes are sampled
  glm::dvec3 exitWorld{0.0};       ///< the position from which they are sampled
  float distance = 0.0f;           ///< inside the glass
  float roughness = 0.0f;          ///< of a mirror with the same scattering
  int mirrored = 0;                ///< total internal reflections
  glm::vec3 transmittance{1.0f};   ///< Beer's law
  glm::vec3 passed{0.0f};          ///< factor of the sampled light: transmission, absorption, tint
  glm::vec3 looked{0.0f};          ///< light of probes and sky in that direction
  float stands = 0.0f;             ///< share of it that is replaced by the frame behind the glass
  int lookups = 0;
  float brightestTexel = 0.0f;
  Phrase sources;  ///< "probe \"ball\" 100.0 %"

  glm::vec3 light() const { return passed * looked; }
};

}  // namespace boxprobe
