// See display_picture.h.
#include "app/session/display_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace boxprobe {

std::array<std::uint8_t, 3> differenceBytes(double difference) {
  // As lightness grows evenly: matplotlib's "inferno" at nine places.
  static constexpr int kColors[][3] = {{0, 0, 4},     {31, 12, 72},   {85, 15, 109},  {136, 34, 106}, {186, 54, 85},
                                       {227, 89, 51}, {249, 140, 10}, {249, 201, 50}, {252, 255, 164}};
  constexpr int kLast = static_cast<int>(std::size(kColors)) - 1;
  const double at = std::clamp(difference / kMostDifference, 0.0, 1.0) * kLast;
  const int below = std::min(static_cast<int>(at), kLast - 1);
  const double share = at - below;
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t c = 0; c < bytes.size(); ++c) {
    bytes[c] =
        static_cast<std::uint8_t>(std::lround((1.0 - share) * kColors[below][c] + share * kColors[below + 1][c]));
  }
  return bytes;
}

ImageRgba8 displayPicture(const ImageRgbaF& linear, double exposure, Tone tone) {
  ImageRgba8 display{linear.width, linear.height, {}, {}};
  display.pixels.reserve(linear.pixels.size());
  for (std::size_t i = 0; i + 3 < linear.pixels.size(); i += 4) {
    const float* p = &linear.pixels[i];
    for (const std::uint8_t byte : displayBytes({p[0], p[1], p[2]}, exposure, tone)) display.pixels.push_back(byte);
    display.pixels.push_back(255);
  }
  return display;
}

ImageRgba8 differencePicture(const ImageRgba8& a, const ImageRgba8& b) {
  ImageRgba8 picture{a.width, a.height, {}, {}};
  picture.pixels.reserve(a.pixels.size());
  for (std::size_t i = 0; i + 3 < a.pixels.size(); i += 4) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixels[i + c] - b.pixels[i + c]));
    for (const std::uint8_t byte : differenceBytes(most / 255.0)) picture.pixels.push_back(byte);
    picture.pixels.push_back(255);
  }
  return picture;
}

}  // namespace boxprobe
