// What is said of one probe: its projection with the numbers put in, its lookups, their texels. Called by
// explanationSections.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "filters/explain/explanation.h"
#include "filters/explain/explanation_rows.h"

namespace boxprobe {

struct ExplanationDetail {
  /// Of each lookup, the texels with the largest shares; the rest is summed up in one line.
  std::size_t texelsPerLookup = 8;
  /// A probe's lookups are all shown up to this many; of more, the brightest few, and the rest in one line.
  std::size_t lookupsPerProbe = 16;
  std::size_t lookupsOfMany = 4;
  /// Light of a texel, where the caller holds the probe's map; may be empty.
  std::function<std::optional<glm::vec3>(const ProbeExplanation&, const TexelShare&)> texelValue;
};

/// Of `e.probes[index]`.
ExplanationSection probeSection(const Explanation& e, std::size_t index, const ExplanationDetail& detail);

}  // namespace boxprobe
