// The explanation of a pixel, line by line: symbols, formulas with their numbers, units, meanings. `boxprobe explain`
// and the window's card both lay out these lines, so that they agree.
#pragma once

#include <optional>
#include <vector>

#include "filters/explain/explanation.h"
#include "filters/explain/explanation_rows.h"
#include "filters/explain/probe_section.h"

namespace boxprobe {

/// Pixel, surface, each probe (the largest share first), the sky, the sum. Without the notes, which callers show first.
std::vector<ExplanationSection> explanationSections(const Explanation& e, const ExplanationDetail& detail = {});

/// The largest difference of a component between computed and rendered colour, relative to the brightest texel sampled
/// (or to the colour if nothing was sampled); nothing if the pixel was not drawn.
std::optional<float> relativeDifference(const Explanation& e);

}  // namespace boxprobe
