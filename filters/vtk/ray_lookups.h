// What a technique fetches at a point, found by running its own code: direction, level and share of every fetch. A
// technique that comes later shows by itself. Called by the calculation of rays; knows no texture.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "filters/math/technique_table.h"

namespace boxprobe {

struct RayLookup {
  glm::vec3 direction{0.0f};  ///< probe frame, as handed to the map; not unit
  float level = 0.0f;
  float share = 0.0f;  ///< of the technique's value
};

/// In the order of the technique's fetches. Nothing non-finite is passed on.
std::vector<RayLookup> recordLookups(const EvaluationRow& technique, const shading::ProbeShape& shape,
                                     const shading::ShadingPoint& point);

}  // namespace boxprobe
