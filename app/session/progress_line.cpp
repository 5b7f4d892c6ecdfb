// See progress_line.h.
#include "app/session/progress_line.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "filters/platform/terminal.h"

namespace boxprobe {

namespace {

// For a program that starts this one, such as the window's measurements: BOXPROBE_PROGRESS=lines.
bool progressAsLines() {
  const char* form = std::getenv("BOXPROBE_PROGRESS");
  return form != nullptr && std::strcmp(form, "lines") == 0;
}

}  // namespace

ProgressLine::ProgressLine(std::string label, bool enabled)
    : label_(std::move(label)), lines_(progressAsLines()), enabled_(enabled && (lines_ || errorsGoToTerminal())) {
  timeLeft_.update(0.0, 0.0);  // the work starts here, not where it is first told of
}

ProgressLine::~ProgressLine() {
  if (shownPercent_ >= 0 && !lines_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::show(double fraction) {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  const auto seconds = timeLeft_.update(fraction, passed.count());
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (!enabled_ || percent == shownPercent_) return;
  shownPercent_ = percent;
  if (lines_) {
    std::fprintf(stderr, "progress %d\n", percent);
    std::fflush(stderr);
    return;
  }
  constexpr int width = 30;
  const int filled = percent * width / 100;
  const std::string left = seconds && percent < 100 ? ", " + TimeLeft::text(*seconds).english() : std::string();
  std::fprintf(stderr, "\r%s [%s%s] %3d %%%s\x1b[K", label_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(width - filled), '.').c_str(), percent, left.c_str());
  std::fflush(stderr);
}

}  // namespace boxprobe
