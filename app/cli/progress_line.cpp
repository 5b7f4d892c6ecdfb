// See progress_line.h.
#include "app/cli/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace boxprobe {

ProgressLine::ProgressLine(std::string label, bool enabled)
    : label_(std::move(label)), enabled_(enabled && isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shownPercent_ >= 0) std::fputs("\r\x1b[K", stderr);
}

// By what was done so far; nothing while that says little.
std::string ProgressLine::timeLeft(double fraction) const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  if (fraction < 0.03 || fraction >= 1.0 || passed.count() < 1.0) return {};
  const auto seconds = static_cast<long>(passed.count() * (1.0 - fraction) / fraction + 0.5);
  if (seconds < 100) return ", " + std::to_string(seconds) + " s left";
  return ", " + std::to_string((seconds + 30) / 60) + " min left";
}

void ProgressLine::show(double fraction) {
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (!enabled_ || percent == shownPercent_) return;
  shownPercent_ = percent;
  constexpr int width = 30;
  const int filled = percent * width / 100;
  std::fprintf(stderr, "\r%s [%s%s] %3d %%%s\x1b[K", label_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(width - filled), '.').c_str(), percent, timeLeft(fraction).c_str());
  std::fflush(stderr);
}

}  // namespace boxprobe
