// CPU time of this process, all threads. Run times are quoted in it, because wall time on a shared machine is noisy.
#pragma once

#include <sys/resource.h>

namespace boxprobe {

/// User and system seconds since the process started.
inline double processCpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

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
