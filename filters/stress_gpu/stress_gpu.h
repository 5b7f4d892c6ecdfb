// The stress test on the GPU: the same inputs, in float textures, go through the shaders that draw, into float targets,
// and are compared with the results of C++. Needs the window's OpenGL context current.
#pragma once

#include <functional>
#include <vector>

#include "filters/stress/stress_run.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Runs the subjects of `plan` that have shader text: every technique and most terms. In a cell's tally, `nonFinite`
/// and `broken` count NaN results of the GPU; errors are differences from C++: of the hit in box sizes, of the sampled
/// direction (`kRelative`, whose largest component is 1) or a term's value, and of the level. They have no bounds,
/// because drivers differ in the last digits. If `progress` returns false, the run stops and the result is empty.
/// Throws WorkError if the driver refuses a shader.
std::vector<stress::StressCell> runStressGpu(vtkOpenGLRenderWindow* window, const stress::StressPlan& plan,
                                             const std::function<bool(double)>& progress);

}  // namespace boxprobe
