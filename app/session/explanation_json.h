// The calculation of a pixel as JSON, for `boxprobe explain --json` and the window's clipboard.
#pragma once

#include <optional>
#include <string>

#include "filters/explain/explanation.h"
#include "filters/explain/verdict.h"

namespace boxprobe {

/// One JSON object, indented, ended by a line break. What is not defined is null. `color` is as rendered where the
/// pixel was drawn; `colorComputed` beside it.
std::string explanationJson(const Explanation& e, const std::optional<Verdict>& verdict = {});

}  // namespace boxprobe
