// What is said of one probe: its projection with the numbers put in, its lookups, their texels. Called by
// explanationSections.
#pragma once

#include <cstddef>

#include "filters/explain/explanation_sections.h"

namespace boxprobe {

/// Of `e.probes[index]`.
ExplanationSection probeSection(const Explanation& e, std::size_t index, const ExplanationDetail& detail);

}  // namespace boxprobe
