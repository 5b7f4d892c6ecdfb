// The calculation of one pixel, done again on the CPU with the shader's own mathematics: from what the surface is to
// the linear colour, every step kept. Called by the scene renderer with what the GPU says about the surface; knows no
// GL.
#pragma once

#include "filters/explain/explain_input.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// Total: whatever is undefined is left out and said in `notes`.
Explanation explainPixel(const ExplainInput& input);

}  // namespace boxprobe
