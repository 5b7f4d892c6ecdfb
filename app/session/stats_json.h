// What ran, as the JSON of --stats and --json. Filled by `render` and by the window at its end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

struct RunStats {
  Counters counters;
  Times times;
  /// CPU seconds of the process from its start until its first frame with all probes ready was there: written to its
  /// file by `render`, swapped to the screen by the window.
  std::optional<double> startToFirstFrameCpuSeconds;
  std::optional<double> modelLoadCpuSeconds;  ///< reading scene and models, all threads
  std::vector<double> frameCpuSeconds;        ///< one entry a timed frame
  std::size_t probeBytes = 0;                 ///< textures of all probes, on the graphics side
  std::string glRenderer, glVersion;
  int anisotropy = 1;  ///< of textures
};

/// What `renderer` counted, and the names of the OpenGL that drew in `window`, whose context must be current.
RunStats collectStats(const SceneRenderer& renderer, vtkOpenGLRenderWindow* window);

/// One JSON object, indented, ended by a line break. What was not measured is null. The peak of the resident set is
/// taken at the time of the call.
std::string statsJson(const RunStats& stats);

}  // namespace boxprobe
