// The curve of sRGB as IEC 61966-2-1 prints it, in double: judges pictures without the program's own functions.
#pragma once

#include <algorithm>
#include <cmath>

namespace boxprobe::test {

/// 0 to 1 of linear light, which is clamped first.
inline double shownLight(double linear) {
  const double l = std::clamp(linear, 0.0, 1.0);
  return l > 0.0031308 ? 1.055 * std::pow(l, 1.0 / 2.4) - 0.055 : l * 12.92;
}

/// And back.
inline double lightShown(double shown) {
  return shown > 0.04045 ? std::pow((shown + 0.055) / 1.055, 2.4) : shown / 12.92;
}

}  // namespace boxprobe::test
