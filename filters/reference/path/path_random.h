// Sample points: an Owen-scrambled (0,2) sequence for each pair of dimensions of a path, each in a different order
// (Burley 2020, "Practical Hash-based Owen Scrambling"; the hash is from Laine and Karras 2011). Independent of the
// number of threads: a point depends on pixel, sample, dimension and seed alone.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace boxprobe {

class PathRandom {
 public:
  PathRandom(std::uint32_t pixelSeed, std::uint32_t sample) : seed_(pixelSeed), sample_(sample) {}

  /// Both in [0, 1); the next pair of dimensions.
  glm::dvec2 pair() {
    const std::uint32_t dimension = hashed(seed_ + 0x9e3779b9u * ++dimensions_);
    const std::uint32_t index = reversed(scrambled(reversed(sample_), dimension));  // a different order for each pair
    // The first dimension, bits reversed, is the index itself.
    const std::uint32_t x = scrambled(index, hashed(dimension ^ 0xa511e9b3u));
    const std::uint32_t y = scrambled(sobol(index), hashed(dimension ^ 0x63d83595u));
    return {unit(x), unit(y)};
  }
  double one() { return pair().x; }

  static std::uint32_t hashed(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
  }

 private:
  static double unit(std::uint32_t reversedBits) { return reversed(reversedBits) * 0x1p-32; }
  static std::uint32_t reversed(std::uint32_t x) {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
    x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
    return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
  }
  /// Owen's scramble of a bit-reversed number: each bit depends on those above it.
  static std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    return x ^ (x * 0x8d22f6e6u);
  }
  /// The second dimension of Sobol's sequence, bits reversed.
  static std::uint32_t sobol(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t v = 1u << 31; index != 0; index >>= 1, v ^= v >> 1) {
      if ((index & 1u) != 0) result ^= v;
    }
    return reversed(result);
  }

  std::uint32_t seed_, sample_, dimensions_ = 0;
};

}  // namespace boxprobe
