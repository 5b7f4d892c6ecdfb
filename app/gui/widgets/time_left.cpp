// See time_left.h.
#include "app/gui/widgets/time_left.h"

#include <QCoreApplication>
#include <cmath>

namespace boxprobe {

namespace {

/// Before this much time and progress an estimate would jump about.
constexpr double kLeastSeconds = 1.0;
constexpr double kLeastProgress = 0.02;

}  // namespace

std::optional<double> TimeLeft::update(double fraction, double seconds) {
  if (!started_ || fraction < lastFraction_) {
    started_ = true;
    startFraction_ = fraction;
    startSeconds_ = seconds;
  }
  lastFraction_ = fraction;
  const double done = fraction - startFraction_, taken = seconds - startSeconds_;
  if (done < kLeastProgress || taken < kLeastSeconds) return std::nullopt;
  return taken / done * (1.0 - fraction);
}

QString TimeLeft::text(double seconds) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("TimeLeft", text); };
  if (seconds < 1.0) return tr("under 1 s left");
  if (seconds < 90.0) return tr("%1 s left").arg(std::lround(seconds));
  return tr("%1 min left").arg(std::lround(seconds / 60.0));
}

}  // namespace boxprobe
