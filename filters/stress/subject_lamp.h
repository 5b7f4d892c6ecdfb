// Lamps as shapes and lattices of diffuse light under test: see subject_lamp.cpp. Called by the table of terms.
#pragma once

#include "filters/stress/stress_trial.h"

namespace boxprobe::stress {

/// The form factor of a face of the input's box, or of a piece of it, at the input's position.
Trial tryLampDiffuse(const StressInput& input, const StressClass& c, TrialLog* log);
/// Its image among the visible normals, F0 and F90 alike.
Trial tryLampGlossy(const StressInput& input, const StressClass& c, TrialLog* log);
/// Diffuse light from a lattice in the input's box.
Trial tryLattice(const StressInput& input, const StressClass& c, TrialLog* log);

}  // namespace boxprobe::stress
