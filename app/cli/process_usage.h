// What this process has used so far, as the kernel counts it. For --stats and the benchmarks: CPU time, because wall
// time on a shared machine says more about the neighbours.
#pragma once

#include <cstdint>

namespace boxprobe {

/// User and system time of all threads since the process started (software OpenGL draws in threads of this process).
double processCpuSeconds();

/// Largest resident set so far.
std::uint64_t peakResidentBytes();

}  // namespace boxprobe
