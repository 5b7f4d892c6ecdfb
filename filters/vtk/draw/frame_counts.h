// What draws leave behind: counters, the programs seen and the first failure. Written by whoever draws; read by the
// renderer, which reports it. Plain data.
#pragma once

#include <set>
#include <string>

#include "filters/core/base/counters.h"

namespace boxprobe {

struct FrameCounts {
  Counters counters;
  std::set<const void*> drawn;  ///< of the last frame
  const void* drawnLast = nullptr;
  std::string error;  ///< first failure since the models were set

  void beginFrame() {
    drawn.clear();
    drawnLast = nullptr;
    counters.surfacePrograms = counters.programSwitches = 0;
  }
  /// A surface is drawn with `program`, by the frame on the screen.
  void draws(const void* program) {
    drawn.insert(program);
    counters.surfacePrograms = drawn.size();
    counters.programSwitches += program != drawnLast ? 1 : 0;
    drawnLast = program;
  }

  /// Keeps the first failure: what follows is often its consequence. An empty message is none.
  void fail(const std::string& message) {
    if (error.empty()) error = message;
  }
};

}  // namespace boxprobe
