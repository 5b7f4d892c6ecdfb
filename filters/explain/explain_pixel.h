// Recomputes one pixel on the CPU with the shader's own mathematics, from the surface to the linear colour, and keeps
// every step.
#pragma once

#include "filters/explain/explain_input.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// Never throws: undefined steps are left out and mentioned in `notes`.
Explanation explainPixel(const ExplainInput& input);

}  // namespace boxprobe
