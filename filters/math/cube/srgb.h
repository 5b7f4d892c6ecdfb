// The transfer curve of sRGB, for 8-bit pictures and colours that are not decoded by a texture unit.
#pragma once

#include <cstdint>

namespace boxprobe {

/// Linear value, 0 to 1, of the byte of a colour component. Not for alpha, which is stored linear.
float linearOfSrgb(std::uint8_t byte);
/// The same for values between bytes, 0 to 1; not clamped.
double linearOfSrgbValue(double shown);

}  // namespace boxprobe
