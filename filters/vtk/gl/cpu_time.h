// CPU time of this process, all threads. Run times are quoted in it, because wall time on a shared machine is noisy.
#pragma once

#include "filters/platform/process.h"

namespace boxprobe {

/// Adds the CPU time between its construction and destruction to `sum`.
class CpuTimer {
 public:
  explicit CpuTimer(double& sum) : sum_(sum), start_(processCpuSeconds()) {}
  ~CpuTimer() { sum_ += processCpuSeconds() - start_; }
  CpuTimer(const CpuTimer&) = delete;
  CpuTimer& operator=(const CpuTimer&) = delete;

 private:
  double& sum_;
  double start_;
};

}  // namespace boxprobe
