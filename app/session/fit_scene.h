// A probe and a camera from bounds alone: for a probe that the user adds by hand, and a scene without a camera. Called
// by the window; filters/fit knows better what a model is.
#pragma once

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Probe whose box is `bounds` (a margin wider), captured at the centre.
Probe fittedProbe(const Box& bounds);

/// Camera named "main" outside `bounds`, above and to the right, that sees all of it at any aspect ratio of 1 and
/// above.
Camera fittedCamera(const Box& bounds);

}  // namespace boxprobe
