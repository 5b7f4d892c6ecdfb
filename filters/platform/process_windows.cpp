// See process.h.
#include <windows.h>

#include "filters/platform/process.h"
// After windows.h, which it needs.
#include <psapi.h>

#include <cstdlib>

#include "filters/platform/windows_text.h"

namespace boxprobe {

namespace {

double seconds(const FILETIME& time) {
  ULARGE_INTEGER ticks;
  ticks.LowPart = time.dwLowDateTime;
  ticks.HighPart = time.dwHighDateTime;
  return 1e-7 * static_cast<double>(ticks.QuadPart);  // of 100 ns
}

}  // namespace

double processCpuSeconds() {
  FILETIME created{}, ended{}, system{}, user{};
  GetProcessTimes(GetCurrentProcess(), &created, &ended, &system, &user);
  return seconds(system) + seconds(user);
}

std::uint64_t peakResidentBytes() {
  PROCESS_MEMORY_COUNTERS counters{};
  GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
  return counters.PeakWorkingSetSize;
}

std::uint64_t physicalMemoryBytes() {
  MEMORYSTATUSEX memory{};
  memory.dwLength = sizeof memory;
  return GlobalMemoryStatusEx(&memory) != 0 ? memory.ullTotalPhys : 0;
}

long processNumber() {
  return static_cast<long>(GetCurrentProcessId());
}

bool processLives(long number) {
  const HANDLE process = OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(number));
  if (process == nullptr) return GetLastError() != ERROR_INVALID_PARAMETER;
  const bool runs = WaitForSingleObject(process, 0) == WAIT_TIMEOUT;
  CloseHandle(process);
  return runs;
}

std::string userText() {
  wchar_t name[257] = {};
  const DWORD count = GetEnvironmentVariableW(L"USERNAME", name, 257);
  return count > 0 && count < 257 ? narrow(name) : "user";
}

std::string programPath() {
  std::wstring path(32768, L'\0');  // the longest that Windows has
  path.resize(GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
  return narrow(path);
}

void setEnvironment(const char* name, const char* value, bool replace) {
  // The C library's copy, which std::getenv reads; it tells Windows.
  if (replace || std::getenv(name) == nullptr) _putenv_s(name, value);
}

}  // namespace boxprobe
