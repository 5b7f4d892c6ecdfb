// The calculation of a pixel as what is said of it, line by line: symbols, formulas with the numbers put in, units,
// meanings. The text of `boxprobe explain` and the window's card both set these lines, so that they say the same.
// Plain values; knows no layout.
#pragma once

#include <optional>
#include <vector>

#include "filters/explain/explanation.h"
#include "filters/explain/explanation_rows.h"
#include "filters/explain/probe_section.h"

namespace boxprobe {

/// Pixel, surface, each probe (the largest share first), the sky, the sum. Notes are left to the caller: they come
/// first.
std::vector<ExplanationSection> explanationSections(const Explanation& e, const ExplanationDetail& detail = {});

/// Largest difference of a component between computed and rendered colour, relative to the brightest texel fetched (to
/// the colour itself where nothing was fetched); nothing if the pixel was not drawn.
std::optional<float> relativeDifference(const Explanation& e);

}  // namespace boxprobe
