// Results of one subject on many inputs of one class. Adding and merging are order-independent, so the report does not
// depend on threads.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "filters/stress/stress_trial.h"

namespace boxprobe::stress {

/// Errors binned by size, eight bins per octave: quantiles are accurate to 9 %.
class ErrorHistogram {
 public:
  void add(double error);
  void merge(const ErrorHistogram& other);
  bool measured() const { return count_ > 0; }
  double worst() const { return worst_; }
  /// The upper end of the bin that contains the quantile, but at most the largest error.
  double quantile(double share) const;

 private:
  static constexpr int kPerOctave = 8, kLeastOctave = -60, kBins = 1024;  // 2^-60 to 2^68
  std::uint64_t count_ = 0;
  double worst_ = 0.0;
  std::vector<std::uint64_t> bins_;  // empty until something is counted
};

struct StressTally {
  std::uint64_t count = 0;
  std::uint64_t nonFinite = 0;   ///< inputs with a NaN or infinite result
  std::uint64_t badLookups = 0;  ///< inputs with a lookup that has no direction or is outside the chain
  std::uint64_t broken = 0;      ///< inputs that exceed a bound, including the above
  std::uint64_t wrong = 0;       ///< inputs with a visible error
  std::array<ErrorHistogram, kMeasures> errors;
  double worstSeverity = -1.0;
  std::uint64_t worstIndex = 0;  ///< the input with the largest error

  void add(const Trial& trial, std::uint64_t index);
  void merge(const StressTally& other);
};

}  // namespace boxprobe::stress
