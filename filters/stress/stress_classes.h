// The classes of inputs that the stress test draws from: each a place where projection mathematics is known to break.
// One row each; the runner, the command line and the tests iterate them. Knows no technique and no error bound.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "filters/stress/stress_input.h"
#include "filters/stress/stress_random.h"

namespace boxprobe::stress {

/// What of the promise a class is held to beside "finite, and levels within the chain", which all are.
enum class Held {
  All,      ///< every bound
  ByReach,  ///< errors count in units of the distance to the box: no float position is known better
  Finite,   ///< no more: sizes below the smallest normal float, or input that is NaN
  Sliding   ///< all but the bevelled box, whose exit is ill-conditioned there: counted as a class of its own
};

struct StressClass {
  std::string_view id;
  std::string_view help;
  void (*shape)(StressInput&, StressRandom&);  ///< turns an ordinary input into one of this class
  Held held = Held::All;
};

const std::vector<StressClass>& stressClasses();

/// Input number `index` of a class, for one subject: depends on nothing else. `parameters`: what is drawn beside.
StressInput makeInput(const StressClass& c, std::string_view subject, std::uint64_t seed, std::uint64_t index,
                      const std::vector<const ParameterRow*>& parameters);

}  // namespace boxprobe::stress
