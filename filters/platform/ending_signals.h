// Signals that ask the process to end, and what may be done while one is handled.
#pragma once

#include <cstddef>

namespace boxprobe {

/// On POSIX both are called in a signal handler, where they may call only what says so; on Windows in a thread of their
/// own.
struct EndingHandlers {
  void (*arrived)(int number);  ///< SIGINT, SIGTERM, SIGHUP; Ctrl+C, the console closed, the user logged off
  void (*late)();               ///< after callLateIn()
};

/// From now on those signals no longer end the process by themselves. A SIGHUP that the parent ignores (nohup) stays
/// ignored. To be called once before giveBackEndingSignals().
void takeEndingSignals(const EndingHandlers& handlers);
/// As before takeEndingSignals(); late() is called no more.
void giveBackEndingSignals();

/// Calls late() so many milliseconds from now, in the place of an earlier call that is due. In handlers, too.
void callLateIn(long milliseconds) noexcept;

/// Writes all bytes; false if that failed. In handlers, too.
bool writeAll(int descriptor, const char* bytes, std::size_t count) noexcept;
/// Writes a file that may be there already; false if that failed. In handlers, too.
bool writeFileNow(const char* path, const char* bytes, std::size_t count) noexcept;
/// Ends the process in the signal's own way: its parent sees status 128 + number. In handlers, too.
[[noreturn]] void endBySignal(int number) noexcept;

/// Writing to a closed pipe, or beyond the limit on a file's size, becomes an error of the write.
void ignoreWriteSignals();

}  // namespace boxprobe
