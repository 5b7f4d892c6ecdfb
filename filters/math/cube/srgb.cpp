// IEC 61966-2-1.
#include "filters/math/cube/srgb.h"

#include <array>
#include <cmath>

namespace boxprobe {

float linearOfSrgb(std::uint8_t byte) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double c = static_cast<double>(i) / 255.0;
      values[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return values;
  }();
  return table[byte];
}

}  // namespace boxprobe
