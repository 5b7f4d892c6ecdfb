// See process.h.
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "filters/platform/process.h"

#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

namespace boxprobe {

namespace {

rusage used() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);  // cannot fail with these arguments
  return usage;
}

}  // namespace

double processCpuSeconds() {
  const rusage usage = used();
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

std::uint64_t peakResidentBytes() {
#ifdef __APPLE__
  constexpr std::uint64_t kUnit = 1;
#else
  constexpr std::uint64_t kUnit = 1024;  // Linux counts KiB
#endif
  return static_cast<std::uint64_t>(used().ru_maxrss) * kUnit;
}

std::uint64_t physicalMemoryBytes() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), pageBytes = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || pageBytes <= 0) return 0;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageBytes);
}

long processNumber() {
  return static_cast<long>(::getpid());
}

bool processLives(long number) {
  return number <= 0 || ::kill(static_cast<pid_t>(number), 0) == 0 || errno != ESRCH;
}

std::string userText() {
  return std::to_string(::getuid());
}

std::string programPath() {
#ifdef __APPLE__
  char path[4096];
  std::uint32_t size = sizeof path;
  return _NSGetExecutablePath(path, &size) == 0 ? std::string(path) : std::string();
#else
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown).string();
#endif
}

void setEnvironment(const char* name, const char* value, bool replace) {
  ::setenv(name, value, replace ? 1 : 0);
}

}  // namespace boxprobe
