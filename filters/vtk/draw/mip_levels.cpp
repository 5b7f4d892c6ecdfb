#include "filters/vtk/draw/mip_levels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boxprobe {

namespace {

/// Where the interpolation lies between two texels of the level above.
struct Tap {
  std::size_t first = 0, second = 0;
  float share = 0.0f;  ///< of the second
};

std::vector<Tap> taps(int from, int to) {
  std::vector<Tap> result;
  for (int i = 0; i < to; ++i) {
    const float place = (static_cast<float>(i) + 0.5f) * static_cast<float>(from) / static_cast<float>(to) - 0.5f;
    const int first = std::clamp(static_cast<int>(std::floor(place)), 0, from - 1);
    result.push_back({static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(first + 1, from - 1)),
                      place - static_cast<float>(first)});
  }
  return result;
}

constexpr int kFine = 1 << 14;  // steps of light, fine enough for the darkest byte

struct Curves {
  std::array<float, 256> light{};              ///< of a byte, times kFine
  std::array<std::uint8_t, kFine + 1> byte{};  ///< of light

  // IEC 61966-2-1.
  Curves() {
    for (std::size_t i = 0; i < light.size(); ++i) {
      const double c = static_cast<double>(i) / 255.0;
      light[i] = static_cast<float>(kFine * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4)));
    }
    for (std::size_t i = 0; i < byte.size(); ++i) {
      const double l = static_cast<double>(i) / kFine;
      const double c = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055;
      byte[i] = static_cast<std::uint8_t>(255.0 * c + 0.5);
    }
  }
};

template <typename Decode, typename Encode>
std::uint8_t mixed(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c, const std::uint8_t* d, float x,
                   float y, const Decode& decode, const Encode& encode) {
  const float upper = (1.0f - x) * decode(*a) + x * decode(*b), lower = (1.0f - x) * decode(*c) + x * decode(*d);
  return encode((1.0f - y) * upper + y * lower);
}

}  // namespace

MipLevel nextMipLevel(int width, int height, const std::vector<std::uint8_t>& pixels, bool srgb) {
  static const Curves curves;
  const auto light = [](std::uint8_t byte) { return curves.light[byte]; };
  const auto byteOfLight = [](float value) { return curves.byte[static_cast<std::size_t>(value + 0.5f)]; };
  const auto number = [](std::uint8_t byte) { return static_cast<float>(byte); };
  const auto byteOfNumber = [](float value) { return static_cast<std::uint8_t>(value + 0.5f); };
  MipLevel level{std::max(width / 2, 1), std::max(height / 2, 1), {}};
  level.pixels.resize(std::size_t(4) * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
  const std::vector<Tap> columns = taps(width, level.width), rows = taps(height, level.height);
  std::uint8_t* out = level.pixels.data();
  for (const Tap& row : rows) {
    const std::uint8_t* upper = pixels.data() + 4 * row.first * static_cast<std::size_t>(width);
    const std::uint8_t* lower = pixels.data() + 4 * row.second * static_cast<std::size_t>(width);
    for (const Tap& column : columns) {
      const std::size_t left = 4 * column.first, right = 4 * column.second;
      for (std::size_t channel = 0; channel < 4; ++channel, ++out) {
        const std::uint8_t *a = upper + left + channel, *b = upper + right + channel, *c = lower + left + channel,
                           *d = lower + right + channel;
        *out = srgb && channel < 3 ? mixed(a, b, c, d, column.share, row.share, light, byteOfLight)
                                   : mixed(a, b, c, d, column.share, row.share, number, byteOfNumber);
      }
    }
  }
  return level;
}

}  // namespace boxprobe
