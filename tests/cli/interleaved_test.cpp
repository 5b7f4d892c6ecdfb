// The statistics the benchmarks judge by, on samples whose answer is known.
#include "filters/reference/measure/interleaved.h"

#include <gtest/gtest.h>

#include <random>

namespace boxprobe::bench {
namespace {

TEST(Interleaved, EachKindComesFirstInTurn) {
  std::string order;
  const Samples samples = interleave(
      4, [&] { return order += 'a', 1.0; }, [&] { return order += 'b', 2.0; });
  EXPECT_EQ(order, "abbaabba");
  EXPECT_EQ(samples.a, std::vector<double>(4, 1.0));
  EXPECT_EQ(samples.b, std::vector<double>(4, 2.0));
}

TEST(Interleaved, Median) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 2.0, 3.0}), 2.5);
}

TEST(Interleaved, IntervalHoldsTheTrueRatioAboutAsOftenAsItSays) {
  std::mt19937 random(7);
  std::lognormal_distribution<double> noise(0.0, 0.1);
  int holding = 0;
  constexpr int trials = 200;
  for (int trial = 0; trial < trials; ++trial) {
    Samples samples;
    for (int i = 0; i < 60; ++i) {
      samples.a.push_back(1.05 * noise(random));
      samples.b.push_back(noise(random));
    }
    const Ratio ratio = ratioOfMedians(samples, 400, static_cast<std::uint32_t>(trial));
    EXPECT_LT(ratio.low, ratio.high);
    if (ratio.low <= 1.05 && 1.05 <= ratio.high) ++holding;
  }
  EXPECT_GE(holding, trials * 90 / 100);
}

}  // namespace
}  // namespace boxprobe::bench
