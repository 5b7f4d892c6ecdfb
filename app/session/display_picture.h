// Linear pictures in display colours, and what is between two of them in false colours. Called by whatever shows or
// writes such pictures; knows no scene.
#pragma once

#include <array>
#include <cstdint>

#include "filters/core/scene/model.h"
#include "filters/math/shared/display_math.h"

namespace boxprobe {

/// Opaque.
ImageRgba8 displayPicture(const ImageRgbaF& linear, double exposure, Tone tone);

/// The difference of display colours, 0 to 1, from which on the colour does not change.
inline constexpr double kMostDifference = 0.25;
/// Black for none, by purple, red and yellow to white: lighter is more, for every eye.
std::array<std::uint8_t, 3> differenceBytes(double difference);
/// differenceBytes() of each pixel's channel that differs most. The sizes must be equal.
ImageRgba8 differencePicture(const ImageRgba8& a, const ImageRgba8& b);

}  // namespace boxprobe
