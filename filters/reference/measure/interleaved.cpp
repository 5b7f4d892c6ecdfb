// See interleaved.h. Bootstrap: Efron and Tibshirani, An Introduction to the Bootstrap (1993), the percentile interval.
#include "filters/reference/measure/interleaved.h"

#include <algorithm>
#include <random>

namespace boxprobe::bench {

Samples interleave(int pairs, const std::function<double()>& a, const std::function<double()>& b) {
  Samples samples;
  for (int i = 0; i < pairs; ++i) {
    if (i % 2 == 0) samples.a.push_back(a());
    samples.b.push_back(b());
    if (i % 2 != 0) samples.a.push_back(a());
  }
  return samples;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

namespace {

double redrawnRatio(const Samples& samples, std::mt19937& random) {
  std::uniform_int_distribution<std::size_t> anyPair(0, samples.a.size() - 1);
  Samples drawn = samples;
  for (std::size_t k = 0; k < samples.a.size(); ++k) {
    const std::size_t pair = anyPair(random);
    drawn.a[k] = samples.a[pair];
    drawn.b[k] = samples.b[pair];
  }
  return median(drawn.a) / median(drawn.b);
}

}  // namespace

Ratio ratioOfMedians(const Samples& samples, int resamples, std::uint32_t seed) {
  return meanRatioOfMedians({samples}, resamples, seed);
}

Ratio meanRatioOfMedians(const std::vector<Samples>& kinds, int resamples, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto mean = [&](const auto& ratio) {
    double sum = 0.0;
    int count = 0;
    for (const Samples& samples : kinds) {
      if (samples.a.empty()) continue;
      sum += ratio(samples);
      ++count;
    }
    return count > 0 ? sum / count : 0.0;
  };
  std::vector<double> ratios;
  for (int i = 0; i < resamples; ++i) {
    ratios.push_back(mean([&](const Samples& samples) { return redrawnRatio(samples, random); }));
  }
  std::sort(ratios.begin(), ratios.end());
  const auto at = [&](double fraction) {
    return ratios[static_cast<std::size_t>(fraction * static_cast<double>(resamples - 1))];
  };
  return {mean([](const Samples& s) { return median(s.a) / median(s.b); }), at(0.025), at(0.975)};
}

}  // namespace boxprobe::bench
