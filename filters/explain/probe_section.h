// The part of an explanation about one probe: its projection with numbers, its lookups, their texels.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "filters/explain/explanation.h"
#include "filters/explain/explanation_rows.h"

namespace boxprobe {

struct ExplanationDetail {
  /// For each lookup, the texels with the largest shares; the rest is summed up in one line.
  std::size_t texelsPerLookup = 8;
  /// Up to this many lookups of a probe are all shown; of more, the brightest, and the rest in one line.
  std::size_t lookupsPerProbe = 16;
  std::size_t lookupsOfMany = 4;
  /// The light of a texel, if the caller has the probe's map; may be empty.
  std::function<std::optional<glm::vec3>(const ProbeExplanation&, const TexelShare&)> texelValue;
};

/// For `e.probes[index]`.
ExplanationSection probeSection(const Explanation& e, std::size_t index, const ExplanationDetail& detail);

}  // namespace boxprobe
