// What of a pixel's calculation is glass: where the view goes on, what it is looked up with, what is left of it. Part
// of an Explanation; made by explain_glass.cpp. Colours linear, lengths in scene units.
#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace boxprobe {

struct GlassExplanation {
  std::string form;   ///< "one-pass", "two-pass", "two-interface", "thin"
  bool back = false;  ///< the eye sees the inside of the surface
  float ior = 1.5f;
  float eta = 1.0f;                ///< n1 / n2, n1 on the eye's side
  float reflectance = 0.0f;        ///< Fresnel's; 1: totally reflected
  bool followed = false;           ///< from within: what is mirrored was followed on to where it leaves
  glm::vec3 directionWorld{0.0f};  ///< what the probes are asked for
  glm::dvec3 exitWorld{0.0};       ///< from there
  float distance = 0.0f;           ///< within the glass
  float roughness = 0.0f;          ///< of a mirror that would scatter as far
  int mirrored = 0;                ///< times within, totally
  glm::vec3 transmittance{1.0f};   ///< Beer's law
  glm::vec3 passed{0.0f};          ///< factor of what is looked up: not reflected, not absorbed, tinted
  glm::vec3 looked{0.0f};          ///< what the probes and the sky show there
  float stands = 0.0f;             ///< share of it that the picture shows from what is drawn behind
  int lookups = 0;
  float brightestTexel = 0.0f;
  std::string sources;  ///< "probe \"ball\" 100.0 %"

  glm::vec3 light() const { return passed * looked; }
};

}  // namespace boxprobe
