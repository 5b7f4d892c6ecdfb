// Shader source that converts linear light to display colours, for surfaces, sky and averaged frames. Reads the
// uniforms of shaders/gpu/output_uniforms.glsl.
#pragma once

#include <string>

#include "filters/math/shared/display_math.h"

namespace boxprobe {

/// Defines bpOutput(). `quick`: display colours may be off by a fiftieth of an 8-bit step. A program contains one tone
/// curve, because software renderers evaluate both sides of a branch.
std::string displaySource(Tone tone, bool quick);

/// The same as a key, to distinguish programs.
std::string displayKey(Tone tone, bool quick);

}  // namespace boxprobe
