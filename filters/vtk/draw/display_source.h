// The shader text that makes display colours of linear light: one for surfaces, sky and the mean of frames. Reads the
// uniforms of shaders/gpu/output_uniforms.glsl.
#pragma once

#include <string>

#include "filters/math/shared/display_math.h"

namespace boxprobe {

/// Defines bpOutput(). `quick`: display colours may be off by a fiftieth of an 8-bit step. A program has one tone:
/// software renderers work out both sides of a branch.
std::string displaySource(Tone tone, bool quick);

/// The same as a word, to tell programs apart by.
std::string displayKey(Tone tone, bool quick);

}  // namespace boxprobe
