// A pipe that wakes an event loop from a signal handler.
#pragma once

namespace boxprobe {

class WakePipe {
 public:
  WakePipe();
  ~WakePipe();
  WakePipe(const WakePipe&) = delete;
  WakePipe& operator=(const WakePipe&) = delete;

  /// False if none could be made: too many files are open.
  bool isOpen() const { return open_; }
  /// The descriptor to watch. Negative where event loops watch none (Windows): they ask now and then instead.
  int readEnd() const { return ends_[0]; }
  /// The descriptor to write a byte to; negative likewise. Never waits.
  int writeEnd() const { return ends_[1]; }

 private:
  bool open_ = false;
  int ends_[2] = {-1, -1};
};

}  // namespace boxprobe
