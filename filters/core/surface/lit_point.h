// A point of a surface with the light that reaches it, except for what a reference judges: its own light, its diffuse
// light, and its position in the boxes of the probes that it reflects. Made from explanations of pixels; the references
// share nothing else with them. Colours are linear, before exposure.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/core/surface/surface_point.h"

namespace boxprobe {

/// A probe as seen from one point.
struct ProbeAtPoint {
  int index = 0;        ///< in the scene's list; selects its colour in views
  float weight = 0.0f;  ///< share of the pixel, before intensity; probes and sky sum to 1
  float intensity = 1.0f;
  bool captured = false;                 ///< false: no maps yet, so it gives no light
  glm::dmat3 worldFromProbe{1.0};        ///< rotation of the box
  glm::dmat3 mapFromProbe{1.0};          ///< from the box's axes to those of its maps
  glm::vec3 positionProbe{0.0f};         ///< P - C in the probe's axes
  glm::vec3 boxMin{0.0f}, boxMax{0.0f};  ///< probe frame
};

struct LitPoint {
  int x = 0, y = 0;  ///< pixel, from the top left
  bool hit = false;  ///< false: the pixel shows the background, with light `color`
  SurfacePoint surface;
  glm::vec3 direct{0.0f};  ///< light sources, both lobes
  glm::vec3 emissive{0.0f};
  glm::vec3 diffuse{0.0f};  ///< of probes and sky, with albedo, and sheen
  glm::vec3 color{0.0f};    ///< all light, as drawn
  float nDotV = 0.0f;       ///< cosine between shading normal and view, within 1e-5..1
  float skyWeight = 0.0f;
  std::vector<ProbeAtPoint> probes;
};

}  // namespace boxprobe
