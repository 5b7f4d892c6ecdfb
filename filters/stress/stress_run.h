// Runs every subject over every class of inputs on all cores. Called by the command line and the tests.
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
  /// The input that came nearest to, or furthest over, a bound.
  StressInput worstInput(std::uint64_t seed) const;
  /// An input broke the promise, or too many came too near. Published forms promise nothing.
  bool broken() const;
};

struct StressPlan {
  std::uint64_t count = 0;  ///< inputs in all, spread evenly over the cells
  std::uint64_t seed = 1;
  std::vector<const StressClass*> classes;
  std::vector<const StressSubject*> subjects;
};

/// One cell for each class and subject, classes first. `progress(fraction)` is called now and then from the calling
/// thread's side of the work; it returns false to stop, and then the result is empty.
std::vector<StressCell> runStress(const StressPlan& plan, const std::function<bool(double)>& progress);

/// The cells of a plan without results, and how many inputs each gets.
std::vector<StressCell> stressCells(const StressPlan& plan);
std::uint64_t inputsOfCell(const StressPlan& plan, std::size_t cell);

}  // namespace boxprobe::stress
