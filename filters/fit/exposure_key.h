// The exposure that a picture asks for. Called where a bare model is first drawn.
#pragma once

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Factor on linear light so that the display is readable: the median of the covered pixels
/// comes to a middle grey, unless their 95th percentile would then pass 0.9 of white, which comes first. `picture` is
/// linear with coverage in alpha; `skyToo` counts the sky that is seen. 1 where the picture is black or empty. Three
/// digits are kept.
double keyedExposure(const ImageRgbaF& picture, bool skyToo);

}  // namespace boxprobe
