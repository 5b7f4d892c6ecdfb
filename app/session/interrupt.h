// Signals that end the program: a question that long work asks between two steps, so that it stops with nothing half
// written, and an end of its own accord for work that does not ask in time.
#pragma once

#include <optional>
#include <string>

namespace boxprobe {

/// From the first of these on, for as long as it lives, SIGINT, SIGTERM and SIGHUP set a flag that work asks for; a
/// signal that arrives late is still told of by the last check(). What has not ended within 0.7 s of a signal, however
/// busy the machine is, or is sent a second one, ends there: temporary files are removed, one line is printed, and the
/// signal's own end follows (status 128 + its number). So does what has seen the flag and takes long to clear up:
/// nothing is lost by that, as files are renamed when they are whole.
/// A signal that nobody has asked for when the last of these goes ends the program there, in the same way. A SIGHUP
/// that the parent ignores (nohup) stays ignored.
class InterruptGuard {
 public:
  InterruptGuard();
  /// Of a window: a signal also writes a byte to the descriptor `wake`, for an event loop.
  explicit InterruptGuard(int wake);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// Of work that has partial results from now on, which are worth a wait: five seconds from the signal on.
  void waitForPartialResults();

  bool interrupted() const;
  /// The signal's number, or 0.
  int signalNumber() const;
  /// Throws WorkError once a signal has arrived.
  void check() const;

 private:
  std::optional<int> wakeBefore_;
};

/// If a signal ends the process in the middle of a step, `text` is written to `path` and that is said. An empty text:
/// nothing. For one thread.
void keepForSignals(const std::string& path, const std::string& text);

/// Where a signal that ends the process in the middle of a step says so, while standard error is another file; else
/// that.
void sayOfSignalsTo(int descriptor);

/// Writing to a closed pipe, or beyond the limit on a file's size, becomes an error of the write; either would end the
/// process with its temporary files left. For the whole process, its children included.
void answerWriteSignals();

}  // namespace boxprobe
