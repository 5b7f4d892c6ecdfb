// Runs every subject on every class of inputs, on all cores.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "filters/stress/stress_tally.h"

namespace boxprobe::stress {

struct StressCell {
  const StressClass* inputs = nullptr;
  const StressSubject* subject = nullptr;
  StressTally tally;
  /// The input that was closest to a bound, or exceeded it the most.
  StressInput worstInput(std::uint64_t seed) const;
  /// Did an input exceed a bound, or did too many come close? Published forms have no bounds.
  bool broken() const;
};

struct StressPlan {
  std::uint64_t count = 0;  ///< total, distributed evenly over the cells
  std::uint64_t seed = 1;
  std::vector<const StressClass*> classes;
  std::vector<const StressSubject*> subjects;
};

/// One cell per class and subject, classes first. `progress(fraction)` is called occasionally, serialized; if it
/// returns false, the run stops and the result is empty.
std::vector<StressCell> runStress(const StressPlan& plan, const std::function<bool(double)>& progress);

/// The cells of a plan without results, with the number of inputs of each.
std::vector<StressCell> stressCells(const StressPlan& plan);
std::uint64_t inputsOfCell(const StressPlan& plan, std::size_t cell);

}  // namespace boxprobe::stress
