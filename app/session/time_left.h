// How long work will still take, from how far it has come. Called by the progress line and the window's status line;
// the clock is the caller's.
#pragma once

#include <optional>

#include "filters/core/base/phrase.h"

namespace boxprobe {

class TimeLeft {
 public:
  /// `fraction` of the work is done at `seconds` on any clock; a fraction that falls (work was added) begins again.
  /// Nothing until there is enough to judge by.
  std::optional<double> update(double fraction, double seconds);
  void restart() { started_ = false; }

  /// "under 1 s left", "12 s left", "3 min left".
  static Phrase text(double seconds);

 private:
  bool started_ = false;
  double startFraction_ = 0.0, startSeconds_ = 0.0, lastFraction_ = 0.0;
};

}  // namespace boxprobe
