// Remarks on a pixel: what is undefined, left out or unusual.
#pragma once

#include "filters/explain/explain_input.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// Adds one sentence each to `e.notes`, for a pixel that is lit by probes.
void addNotes(Explanation& e, const ExplainInput& in);

}  // namespace boxprobe
