// What is to be said of a pixel beside its numbers: what is undefined there, left out or out of the ordinary. Called by
// explainPixel.
#pragma once

#include "filters/explain/explain_input.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// Adds to `e.notes` one sentence each, of a pixel that is lit by probes.
void addNotes(Explanation& e, const ExplainInput& in);

}  // namespace boxprobe
