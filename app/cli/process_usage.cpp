// See process_usage.h.
#include "app/cli/process_usage.h"

#include <sys/resource.h>

namespace boxprobe {

namespace {
rusage usage() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);  // cannot fail with these arguments
  return used;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}
}  // namespace

double processCpuSeconds() {
  const rusage used = usage();
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::uint64_t peakResidentBytes() {
  return static_cast<std::uint64_t>(usage().ru_maxrss) * 1024;
}  // Linux: KiB

}  // namespace boxprobe
