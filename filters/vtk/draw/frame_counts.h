// Results of draws: counters, the programs used and the first failure. The renderer reports them.
#pragma once

#include <set>
#include <string>

#include "filters/core/base/counters.h"

namespace boxprobe {

struct FrameCounts {
  Counters counters;
  std::set<const void*> drawn;  ///< in the last frame
  const void* drawnLast = nullptr;
  std::string error;  ///< first failure since the models were set

  void beginFrame() {
    drawn.clear();
    drawnLast = nullptr;
    counters.surfacePrograms = counters.programSwitches = 0;
  }
  /// To be called when a surface of the frame on the screen is drawn with `program`.
  void draws(const void* program) {
    drawn.insert(program);
    counters.surfacePrograms = drawn.size();
    counters.programSwitches += program != drawnLast ? 1 : 0;
    drawnLast = program;
  }

  /// Keeps the first failure, of which later ones are often a consequence. Ignores an empty message.
  void fail(const std::string& message) {
    if (error.empty()) error = message;
  }
};

}  // namespace boxprobe
