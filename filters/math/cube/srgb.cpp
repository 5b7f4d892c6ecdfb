// IEC 61966-2-1.
#include "filters/math/cube/srgb.h"

#include <array>
#include <cmath>

namespace boxprobe {

double linearOfSrgbValue(double shown) {
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

float linearOfSrgb(std::uint8_t byte) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<float>(linearOfSrgbValue(static_cast<double>(i) / 255.0));
    }
    return values;
  }();
  return table[byte];
}

}  // namespace boxprobe
