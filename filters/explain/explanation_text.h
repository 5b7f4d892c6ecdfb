// The calculation of a pixel as plain text in aligned columns: what `boxprobe explain` prints and the window copies.
#pragma once

#include <optional>
#include <string>

#include "filters/explain/explanation_sections.h"
#include "filters/explain/verdict.h"

namespace boxprobe {

/// Lines ended by line breaks. The verdict comes first, then notes, each on a line that starts with "! "; "> " marks
/// what decides.
std::string explanationText(const Explanation& e, const ExplanationDetail& detail = {},
                            const std::optional<Verdict>& verdict = {});

}  // namespace boxprobe
