// The exposure that a picture asks for. Called where a bare model is first drawn.
#pragma once

#include "filters/core/scene/model.h"
#include "filters/math/shared/display_math.h"

namespace boxprobe {

/// Factor on linear light so that the display is readable: the median of the covered pixels
/// comes to a middle grey, unless their 95th percentile would then come too near white, which comes first: a tone that
/// compresses highlights lets it come nearer. `picture` is linear with coverage in alpha; `skyToo` counts the sky that
/// is seen. 1 where the picture is black or empty. Three digits are kept.
double keyedExposure(const ImageRgbaF& picture, bool skyToo, Tone tone = Tone::None);

}  // namespace boxprobe
