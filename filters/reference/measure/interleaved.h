// Compares two costs measured in alternation: the statistics of `boxprobe bench` and of the benchmark programs.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace boxprobe::bench {

struct Samples {
  std::vector<double> a, b;  ///< seconds; a[i] and b[i] were measured one after the other
};

/// `pairs` measurements of each; the order alternates, so that a drift of the machine affects both equally.
Samples interleave(int pairs, const std::function<double()>& a, const std::function<double()>& b);

double median(std::vector<double> values);

struct Ratio {
  double value = 0.0;  ///< median of a over median of b
  double low = 0.0;    ///< 95 % bootstrap interval, pairs drawn with replacement
  double high = 0.0;
};

Ratio ratioOfMedians(const Samples& samples, int resamples = 10000, std::uint32_t seed = 1);

/// The mean of the ratios of medians over several kinds of work, with equal weights; pairs are drawn within each kind.
/// Kinds without samples are ignored; 0 without any.
Ratio meanRatioOfMedians(const std::vector<Samples>& kinds, int resamples = 2000, std::uint32_t seed = 1);

}  // namespace boxprobe::bench
