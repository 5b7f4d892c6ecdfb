// What draws leave behind: counters, the programs seen and the first failure. Written by whoever draws; read by the
// renderer, which reports it. Plain data.
#pragma once

#include <set>
#include <string>

#include "filters/core/base/counters.h"

namespace boxprobe {

struct FrameCounts {
  Counters counters;
  std::set<const void*> programs;  ///< seen so far, to count compilations
  std::string error;               ///< first failure since the models were set

  /// Keeps the first failure: what follows is often its consequence.
  void fail(const std::string& message) {
    if (error.empty()) error = message;
  }
};

}  // namespace boxprobe
