// Ctrl-C as a question that long work asks between two steps, so that it stops with nothing half written.
#pragma once

namespace boxprobe {

/// While one lives, the first SIGINT or SIGTERM only sets a flag; a second one ends the process as usual. The previous
/// handlers are put back at the end.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool interrupted() const;
  /// Throws WorkError once a signal has arrived.
  void check() const;

 private:
  struct Handlers;
  Handlers* previous_;
};

}  // namespace boxprobe
