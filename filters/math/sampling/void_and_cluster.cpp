#include "filters/math/sampling/void_and_cluster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace boxprobe {

namespace {

// Standard deviation of a pixel's influence. Below the published 1.5 masks get coarser; towards 2.5 lattices appear.
constexpr double kSigma = 1.9;
// Integers, so that influence can be added and removed exactly; a sum over all 361 pixels in reach stays below 2^31.
constexpr double kUnit = 1 << 22;
constexpr int kReach = 9;  // beyond this distance the influence is below 2e-5

/// A pattern of set pixels, and how crowded each pixel is by them.
class Crowd {
 public:
  explicit Crowd(int size) : size_(size), crowding_(pixels(), 0), set_(pixels(), 0) {
    for (int y = -kReach; y <= kReach; ++y) {
      for (int x = -kReach; x <= kReach; ++x) {
        kernel_.push_back(static_cast<std::int32_t>(kUnit * std::exp(-0.5 * (x * x + y * y) / (kSigma * kSigma))));
      }
    }
  }

  std::size_t pixels() const { return static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_); }
  bool isSet(std::size_t pixel) const { return set_[pixel] != 0; }

  void change(std::size_t pixel, bool on) {
    set_[pixel] = on ? 1 : 0;
    const int column = static_cast<int>(pixel) % size_, row = static_cast<int>(pixel) / size_;
    const std::int32_t* influence = kernel_.data();
    for (int y = -kReach; y <= kReach; ++y) {
      std::int32_t* line = &crowding_[static_cast<std::size_t>(wrapped(row + y) * size_)];
      for (int x = -kReach; x <= kReach; ++x, ++influence) line[wrapped(column + x)] += on ? *influence : -*influence;
    }
  }

  /// The emptiest pixel that is not set.
  std::size_t largestVoid() const {
    std::size_t best = 0;
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    for (std::size_t i = 0; i < pixels(); ++i) {
      if (set_[i] == 0 && crowding_[i] < least) least = crowding_[i], best = i;
    }
    return best;
  }

  /// The most crowded pixel that is set.
  std::size_t tightestCluster() const {
    std::size_t best = 0;
    std::int32_t most = -1;
    for (std::size_t i = 0; i < pixels(); ++i) {
      if (set_[i] != 0 && crowding_[i] > most) most = crowding_[i], best = i;
    }
    return best;
  }

 private:
  int wrapped(int i) const { return ((i % size_) + size_) % size_; }

  int size_;
  std::vector<std::int32_t> crowding_;
  std::vector<std::uint8_t> set_;
  std::vector<std::int32_t> kernel_;
};

}  // namespace

std::vector<std::uint16_t> voidAndCluster(int size, std::uint32_t seed) {
  Crowd crowd(size);
  const std::size_t pixels = crowd.pixels(), first = std::max<std::size_t>(pixels / 10, 1);
  std::mt19937 random(seed);
  for (std::size_t set = 0; set < first;) {
    const std::size_t pixel = random() % pixels;
    if (crowd.isSet(pixel)) continue;
    crowd.change(pixel, true);
    ++set;
  }
  // The most crowded pixel moves to the largest void, until it would move back.
  for (std::size_t moves = 0; moves < 4 * pixels; ++moves) {
    const std::size_t from = crowd.tightestCluster();
    crowd.change(from, false);
    const std::size_t to = crowd.largestVoid();
    crowd.change(to, true);
    if (to == from) break;
  }
  std::vector<std::uint16_t> ranks(pixels, 0);
  const Crowd start = crowd;
  for (std::size_t rank = first; rank-- > 0;) {
    const std::size_t pixel = crowd.tightestCluster();
    crowd.change(pixel, false);
    ranks[pixel] = static_cast<std::uint16_t>(rank);
  }
  // With more than half of the pixels set, the published rule takes the tightest cluster of those not set. On a
  // periodic square that is again the largest void, since the two crowdings add up to a constant.
  crowd = start;
  for (std::size_t rank = first; rank < pixels; ++rank) {
    const std::size_t pixel = crowd.largestVoid();
    crowd.change(pixel, true);
    ranks[pixel] = static_cast<std::uint16_t>(rank);
  }
  return ranks;
}

}  // namespace boxprobe
