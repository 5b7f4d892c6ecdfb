// See stress_trial.h.
#include "filters/stress/stress_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace boxprobe::stress {

namespace {

// Nine digits distinguish all floats.
std::string text(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.9g", value);
  return buffer;
}

std::string exactText(long double value) {
  char buffer[60];
  std::snprintf(buffer, sizeof buffer, "%.15Lg", value);
  return buffer;
}

}  // namespace

void Trial::measure(Measure what, double value, double bound, bool held) {
  if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
  error[what] = std::max(error[what], value);
  constexpr double kShows[kMeasures] = {std::numeric_limits<double>::infinity(), 0.01, 0.01, 0.1};
  wrong = wrong || (held && value > kShows[what]);
  if (!held) return;
  severity = std::max(severity, value / bound);
  broken = broken || value > bound;
}

void Trial::require(bool finiteResult, bool usable) {
  finite = finite && finiteResult;
  lookupsUsable = lookupsUsable && usable;
  if (finiteResult && usable) return;
  broken = wrong = true;
  severity = std::numeric_limits<double>::infinity();
}

void TrialLog::add(const std::string& name, double value) {
  lines_.push_back({name, text(value), {}});
}

void TrialLog::add(const std::string& name, const glm::vec3& value) {
  lines_.push_back({name, text(value.x) + " " + text(value.y) + " " + text(value.z), {}});
}

void TrialLog::add(const std::string& name, double value, long double exact) {
  lines_.push_back({name, text(value), exactText(exact)});
}

void TrialLog::add(const std::string& name, const glm::vec3& value, const std::array<long double, 3>& exact) {
  add(name, value);
  lines_.back().exact = exactText(exact[0]) + " " + exactText(exact[1]) + " " + exactText(exact[2]);
}

}  // namespace boxprobe::stress
