// Glass under test: see subject_glass.cpp.
#pragma once

#include "filters/stress/stress_trial.h"

namespace boxprobe::stress {

Trial tryGlass(const StressInput& input, const StressClass& c, TrialLog* log);

}  // namespace boxprobe::stress
