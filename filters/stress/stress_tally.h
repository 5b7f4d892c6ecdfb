// What many inputs of one class showed of one subject. Adding and merging give the same tally in any order, so the
// report does not depend on threads.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "filters/stress/stress_trial.h"

namespace boxprobe::stress {

/// Errors counted by their size: eight bins an octave, so a quantile is known to 9 %.
class ErrorHistogram {
 public:
  void add(double error);
  void merge(const ErrorHistogram& other);
  bool measured() const { return count_ > 0; }
  double worst() const { return worst_; }
  /// The upper end of the bin that holds it, and never more than the worst.
  double quantile(double share) const;

 private:
  static constexpr int kPerOctave = 8, kLeastOctave = -60, kBins = 1024;  // 2^-60 to 2^68
  std::uint64_t count_ = 0;
  double worst_ = 0.0;
  std::vector<std::uint64_t> bins_;  // empty until something is counted
};

struct StressTally {
  std::uint64_t count = 0;
  std::uint64_t nonFinite = 0;   ///< inputs with a result that is NaN or infinite
  std::uint64_t badLookups = 0;  ///< inputs with a lookup without direction or outside the chain
  std::uint64_t broken = 0;      ///< inputs that break the promise, the above among them
  std::uint64_t wrong = 0;       ///< inputs whose result is so far off that it shows
  std::array<ErrorHistogram, kMeasures> errors;
  double worstSeverity = -1.0;
  std::uint64_t worstIndex = 0;  ///< which input that was

  void add(const Trial& trial, std::uint64_t index);
  void merge(const StressTally& other);
};

}  // namespace boxprobe::stress
