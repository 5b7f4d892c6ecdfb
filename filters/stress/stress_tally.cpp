// See stress_tally.h.
#include "filters/stress/stress_tally.h"

#include <algorithm>
#include <cmath>

namespace boxprobe::stress {

void ErrorHistogram::add(double error) {
  if (bins_.empty()) bins_.resize(kBins);
  int bin = 0;
  if (std::isinf(error)) {
    bin = kBins - 1;
  } else if (error > 0.0) {
    bin = static_cast<int>(std::floor(kPerOctave * (std::log2(error) - kLeastOctave)));
  }
  ++bins_[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))];
  worst_ = std::max(worst_, error);
  ++count_;
}

void ErrorHistogram::merge(const ErrorHistogram& other) {
  if (other.bins_.empty()) return;
  if (bins_.empty()) bins_.resize(kBins);
  for (std::size_t i = 0; i < bins_.size(); ++i) bins_[i] += other.bins_[i];
  worst_ = std::max(worst_, other.worst_);
  count_ += other.count_;
}

double ErrorHistogram::quantile(double share) const {
  const auto below = static_cast<std::uint64_t>(share * static_cast<double>(count_));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    seen += bins_[i];
    if (seen < below || seen == 0) continue;
    return std::min(worst_, i == 0 ? 0.0 : std::exp2((static_cast<double>(i) + 1.0) / kPerOctave + kLeastOctave));
  }
  return worst_;
}

void StressTally::add(const Trial& trial, std::uint64_t index) {
  ++count;
  nonFinite += trial.finite ? 0 : 1;
  badLookups += trial.lookupsUsable ? 0 : 1;
  broken += trial.broken ? 1 : 0;
  wrong += trial.wrong ? 1 : 0;
  for (int i = 0; i < kMeasures; ++i) {
    if (trial.error[static_cast<std::size_t>(i)] != Trial::kNotMeasured) {
      errors[static_cast<std::size_t>(i)].add(trial.error[static_cast<std::size_t>(i)]);
    }
  }
  if (trial.severity > worstSeverity || (trial.severity == worstSeverity && index < worstIndex)) {
    worstSeverity = trial.severity;
    worstIndex = index;
  }
}

void StressTally::merge(const StressTally& other) {
  count += other.count;
  nonFinite += other.nonFinite;
  badLookups += other.badLookups;
  broken += other.broken;
  wrong += other.wrong;
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i].merge(other.errors[i]);
  if (other.worstSeverity > worstSeverity || (other.worstSeverity == worstSeverity && other.worstIndex < worstIndex)) {
    worstSeverity = other.worstSeverity;
    worstIndex = other.worstIndex;
  }
}

}  // namespace boxprobe::stress
