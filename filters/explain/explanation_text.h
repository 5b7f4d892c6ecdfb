// The calculation of a pixel as plain text in aligned columns: what `boxprobe explain` prints and the window copies.
#pragma once

#include <string>

#include "filters/explain/explanation_sections.h"

namespace boxprobe {

/// Lines ended by line breaks. Notes come first, each on a line that starts with "! "; "> " marks what decides.
std::string explanationText(const Explanation& e, const ExplanationDetail& detail = {});

}  // namespace boxprobe
