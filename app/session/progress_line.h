// A single line on stderr that says how far long work is and about how long it will go on; nothing where stderr is not
// a terminal, unless BOXPROBE_PROGRESS=lines asks for lines a program can read ("progress 12").
#pragma once

#include <chrono>
#include <string>

#include "app/session/time_left.h"

namespace boxprobe {

class ProgressLine {
 public:
  /// `enabled` false (--quiet) or nobody who could read it: draws nothing.
  ProgressLine(std::string label, bool enabled);
  ~ProgressLine();  ///< wipes the line, so that what is printed next starts on a clean one
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double fraction);  ///< 0..1; redrawn only when the percentage shown changes

 private:
  std::string label_;
  bool lines_;
  bool enabled_;
  int shownPercent_ = -1;
  TimeLeft timeLeft_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace boxprobe
