// Where the time of a frame goes: parts of it are left out in turn, and frames with and without them are timed one
// after the other. Called by `info --frame --costs` and by the window; the one hands in how a frame is drawn and timed,
// and both show what comes back.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

/// Milliseconds: the median of the differences of frames drawn one after the other, and their quartiles.
struct Cost {
  double median = 0.0, low = 0.0, high = 0.0;
};

struct FrameCosts {
  struct Row {
    std::string name;
    std::string help;  ///< what it is, for a reader who sees the name alone
    Cost cost;
  };
  struct Program {
    std::vector<std::string> objects;  ///< that share it, in this frame
    Cost cost;                         ///< of their pixels
  };
  bool cpuTime = true;  ///< of all threads, where software draws; false: until the graphics card has finished
  int rounds = 0;       ///< frames of each kind
  Cost frame;
  std::vector<Row> parts;  ///< they add up to the frame, but for noise
  Cost overdraw;           ///< of the frame: pixels that are worked out and then covered
  std::vector<Program> programs;
  std::vector<Row> objects;  ///< of their pixels; those that are most expensive first
};

/// Draws and times one frame of `renderer`, seconds. `progress` (0 to 1) may return false to stop: then no rows come
/// back. Afterwards the picture is whole again with the next frame. Every kind is drawn twice before it counts, since
/// programs are made anew for each. Throws WorkError where a frame fails.
FrameCosts measureFrameCosts(SceneRenderer& renderer, int rounds, const std::function<double()>& timedFrame,
                             const std::function<bool(double)>& progress = {});

/// Draws into `window` and waits until that is done: CPU seconds of all threads where software draws, else elapsed
/// ones.
double timedFrameOf(vtkOpenGLRenderWindow* window);

nlohmann::ordered_json frameCostsJson(const FrameCosts& costs);
std::string frameCostsText(const FrameCosts& costs);

}  // namespace boxprobe
