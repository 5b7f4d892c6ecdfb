// The explanation of a pixel as plain text in aligned columns: printed by `boxprobe explain`, copied by the window.
#pragma once

#include <optional>
#include <string>

#include "filters/explain/explanation_sections.h"
#include "filters/explain/verdict.h"

namespace boxprobe {

/// Lines with line breaks. The verdict comes first, then notes, each on a line that starts with "! "; "> " marks
/// decisive rows.
std::string explanationText(const Explanation& e, const ExplanationDetail& detail = {},
                            const std::optional<Verdict>& verdict = {});

}  // namespace boxprobe
