// Chooses the exposure of a picture.
#pragma once

#include "filters/core/scene/model.h"
#include "filters/math/shared/display_math.h"

namespace boxprobe {

/// The factor on linear light that makes a picture readable: the median of the covered pixels becomes middle grey, or
/// less if their 95th percentile would come too close to white; a tone curve that compresses highlights allows more.
/// `picture` is linear with coverage in alpha; `skyToo` includes the visible sky. 1 for a black or empty picture.
/// Rounded to three digits.
double keyedExposure(const ImageRgbaF& picture, bool skyToo, Tone tone = Tone::None);

}  // namespace boxprobe
