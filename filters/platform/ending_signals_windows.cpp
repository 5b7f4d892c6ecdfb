// See ending_signals.h. Windows calls a console's handler in a thread of its own, and a window has no console.
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <csignal>

#include "filters/platform/ending_signals.h"
#include "filters/platform/windows_text.h"

namespace boxprobe {

namespace {

EndingHandlers endingHandlers = {};
HANDLE lateTimer = nullptr;

BOOL WINAPI consoleAsks(DWORD what) {
  const bool key = what == CTRL_C_EVENT || what == CTRL_BREAK_EVENT;
  endingHandlers.arrived(key ? SIGINT : SIGTERM);
  if (!key) Sleep(INFINITE);  // the process ends when this returns; until then its threads have five seconds
  return TRUE;
}

void CALLBACK timeIsOver(void*, BOOLEAN) {
  endingHandlers.late();
}

// With INVALID_HANDLE_VALUE it waits for a call under way, which must not remove the timer itself.
void removeTimer(HANDLE completion) {
  if (lateTimer != nullptr) DeleteTimerQueueTimer(nullptr, lateTimer, completion);
  lateTimer = nullptr;
}

}  // namespace

void takeEndingSignals(const EndingHandlers& handlers) {
  endingHandlers = handlers;
  SetConsoleCtrlHandler(consoleAsks, TRUE);
}

void giveBackEndingSignals() {
  SetConsoleCtrlHandler(consoleAsks, FALSE);
  removeTimer(INVALID_HANDLE_VALUE);
}

void callLateIn(long milliseconds) noexcept {
  removeTimer(nullptr);
  CreateTimerQueueTimer(&lateTimer, nullptr, timeIsOver, nullptr, static_cast<DWORD>(milliseconds), 0,
                        WT_EXECUTEONLYONCE);
}

bool writeAll(int descriptor, const char* bytes, std::size_t count) noexcept {
  constexpr std::size_t kMost = 1u << 30u;  // the C library counts in int
  while (count > 0) {
    const int written = _write(descriptor, bytes, static_cast<unsigned>(std::min(count, kMost)));
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

bool writeFileNow(const char* path, const char* bytes, std::size_t count) noexcept {
  const int file =
      _wopen(wide(path).c_str(), _O_WRONLY | _O_CREAT | _O_TRUNC | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
  if (file < 0) return false;
  const bool written = writeAll(file, bytes, count);
  _close(file);
  return written;
}

void endBySignal(int number) noexcept {
  TerminateProcess(GetCurrentProcess(), static_cast<UINT>(128 + number));
  for (;;) Sleep(INFINITE);
}

void ignoreWriteSignals() {}  // there are none

}  // namespace boxprobe
