// The form of the footprint techniques of 2 lookups and more: pairs turned along the axis that the capture origin sees
// longest (shaders/shared/footprint_turned.glsl).
#pragma once

#include "tests/bench/footprint_form.h"

namespace boxprobe::bench {

/// For 2, 4 or 8 lookups.
FootprintForm turnedForm(int lookups);
/// The constants that its fit starts with.
std::vector<double> turnedStart(int lookups);

}  // namespace boxprobe::bench
