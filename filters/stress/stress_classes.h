// The classes of stress inputs, each a known weakness of projection mathematics. One row each; the runner, the command
// line and the tests iterate them.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "filters/stress/stress_input.h"
#include "filters/stress/stress_random.h"

namespace boxprobe::stress {

/// The bounds that a class must meet besides "finite, and levels within the chain", which apply to all.
enum class Held {
  All,      ///< every bound
  ByReach,  ///< errors are relative to the distance to the box: float positions are no more accurate
  Finite,   ///< no others: sizes below the smallest normal float, or NaN inputs
  Sliding   ///< all but the bevelled box, whose exit is ill-conditioned there: counted as a class of its own
};

struct StressClass {
  std::string_view id;
  std::string_view help;
  void (*shape)(StressInput&, StressRandom&);  ///< turns an ordinary input into one of this class
  Held held = Held::All;
};

const std::vector<StressClass>& stressClasses();

/// Input number `index` of a class, for one subject: deterministic. `parameters`: drawn as well.
StressInput makeInput(const StressClass& c, std::string_view subject, std::uint64_t seed, std::uint64_t index,
                      const std::vector<const ParameterRow*>& parameters);

}  // namespace boxprobe::stress
