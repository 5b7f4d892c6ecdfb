// Records the lookups of any technique, by running it with a map that logs them. New techniques need no code here.
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

/// Runs `evaluate` on `map`, which lies along the axes of its capture. A technique's value is linear in its lookups, so
/// the weight of a lookup is the result when it alone returns 1.
RecordedLookups recordLookups(Evaluate evaluate, const CubeMap& map, const ProbeGeometry& geometry,
                              const shading::ProbeShape& shape, const shading::ShadingPoint& point);

/// The same without a map: directions, levels and weights only.
RecordedLookups recordLookups(Evaluate evaluate, const shading::ProbeShape& shape, const shading::ShadingPoint& point);

}  // namespace boxprobe
