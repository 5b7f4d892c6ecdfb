// The transfer curve of sRGB, for pictures and colours that come in bytes. Called by whatever reads them outside the
// graphics card, which decodes them itself.
#pragma once

#include <cstdint>

namespace boxprobe {

/// Linear value, 0 to 1, of a byte of a colour component. Not for alpha, which is linear as it is.
float linearOfSrgb(std::uint8_t byte);
/// The same of a value between bytes, 0 to 1; not clamped.
double linearOfSrgbValue(double shown);

}  // namespace boxprobe
