// The stress test on the GPU: the same inputs, in float textures, through the shader text that draws, into float
// targets, and compared with what C++ makes of them. Called by the command line and the tests, with the window's
// context current.
#pragma once

#include <functional>
#include <vector>

#include "filters/stress/stress_run.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Subjects of `plan` that have shader text, which is every technique and most terms; the others are left out. Of a
/// cell's tally `nonFinite` and `broken` count results of the GPU that are NaN; errors are differences from C++:
/// of the hit in box sizes, of the looked-up direction (`kRelative`, its largest component being 1) or a term's value,
/// and of the level. They are held to nothing: drivers differ in the last digits. `progress` returns false to stop, and
/// then the result is empty. Throws WorkError where the driver refuses a shader.
std::vector<stress::StressCell> runStressGpu(vtkOpenGLRenderWindow* window, const stress::StressPlan& plan,
                                             const std::function<bool(double)>& progress);

}  // namespace boxprobe
