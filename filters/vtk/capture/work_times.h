// CPU time of captures and filtering so far, for --stats and the status line.
#pragma once

#include <array>
#include <cstdint>

namespace boxprobe {

/// The cost of one bounce of all probes.
struct BounceCost {
  std::uint64_t faces = 0;  ///< captured
  double cpuSeconds = 0.0;  ///< capture and filtering, all threads
};

/// CPU seconds of this process, all threads, by kind of work.
struct Times {
  std::array<BounceCost, 16> bounces;  ///< probes only, the first bounce first
  double captureCpuSeconds = 0.0;
  double prefilterCpuSeconds = 0.0;
};

}  // namespace boxprobe
