// Two costs measured in turn and compared: the statistics of `boxprobe bench` and of the benchmark programs. Knows
// nothing of what is measured.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace boxprobe::bench {

struct Samples {
  std::vector<double> a, b;  ///< seconds; a[i] and b[i] were measured one after the other
};

/// `pairs` times one of each, each first in turn, so that a drift of the machine touches both alike.
Samples interleave(int pairs, const std::function<double()>& a, const std::function<double()>& b);

double median(std::vector<double> values);

struct Ratio {
  double value = 0.0;  ///< median of a over median of b
  double low = 0.0;    ///< 95 % bootstrap interval, pairs drawn with replacement
  double high = 0.0;
};

Ratio ratioOfMedians(const Samples& samples, int resamples = 10000, std::uint32_t seed = 1);

/// Mean over several kinds of work, in equal parts, of the ratio of medians of each; pairs are drawn within each kind.
/// Kinds without samples do not count; 0 without any.
Ratio meanRatioOfMedians(const std::vector<Samples>& kinds, int resamples = 2000, std::uint32_t seed = 1);

}  // namespace boxprobe::bench
