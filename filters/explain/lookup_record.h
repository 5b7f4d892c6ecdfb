// What a technique fetches, whatever technique it is: it is run with a map that writes down every fetch. Used by
// explanations and by the ray filter, so a new technique shows up in both by itself.
#pragma once

#include <vector>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/explain/explanation.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

struct RecordedLookups {
  glm::vec4 value{0.0f};
  std::vector<Lookup> lookups;
};

using Evaluate = glm::vec4 (*)(shading::ProbeMap, shading::ProbeShape, shading::ShadingPoint);

/// Runs `evaluate` on `map`, which is laid out along the axes it was captured with. A technique's value is linear
/// in what it fetches; so the weight of a fetch is what comes out when it alone returns 1.
RecordedLookups recordLookups(Evaluate evaluate, const CubeMap& map, const ProbeGeometry& geometry,
                              const shading::ProbeShape& shape, const shading::ShadingPoint& point);

/// The same without a map: directions, levels and weights only.
RecordedLookups recordLookups(Evaluate evaluate, const shading::ProbeShape& shape, const shading::ShadingPoint& point);

}  // namespace boxprobe
