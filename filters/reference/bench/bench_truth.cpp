#include "filters/reference/bench/bench_truth.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>

#include "filters/reference/light/reflecting_layers.h"
#include "filters/reference/measure/metrics.h"

namespace boxprobe {

namespace {

/// d/dx of (x / (1 + x))^(1/2.2): converts a standard error to tone-mapped values.
double toneMappedSlope(double x) {
  const double y = std::max(x, 1.0e-4);  // at black the slope is infinite, but the tone-mapped spread is not
  return toneMapped(y) / (2.2 * y * (1.0 + y));
}

/// The passes of one pixel, by Welford's algorithm.
struct PassMean {
  glm::dvec3 mean{0.0}, squares{0.0};
  int passes = 0;
  bool exact = false;

  void add(const glm::dvec3& value) {
    ++passes;
    const glm::dvec3 change = value - mean;
    mean += change / static_cast<double>(passes);
    squares += change * (value - mean);
  }
  /// The mean squared standard error of the tone-mapped components of `offset` + the mean.
  double toneMappedVariance(const glm::dvec3& offset) const {
    if (exact || passes < 2) return 0.0;
    double sum = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double slope = toneMappedSlope(offset[c] + mean[c]);
      sum += slope * slope * std::max(squares[c], 0.0) / (passes - 1.0) / passes;
    }
    return sum / 3.0;
  }
};

using Estimate = std::function<glm::dvec3(std::size_t pixel, std::uint64_t seed, bool* exact)>;

TruthColors estimated(std::size_t count, const std::vector<glm::dvec3>& offset, const TruthSettings& settings,
                      const Estimate& estimate, const ReferenceProgress& progress) {
  std::vector<PassMean> sums(count);
  const auto offsetOf = [&](std::size_t i) { return offset.empty() ? glm::dvec3(0.0) : offset[i]; };
  std::atomic<bool> stopped{false};
  std::mutex reporting;
  double done = 0.0;
  const double target = settings.standardError * settings.standardError;
  // Adds passes to each pixel until their spread is small enough.
  const auto work = [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end() && !stopped; ++i) {
      PassMean& sum = sums[i];
      for (int pass = 0; pass < settings.mostPasses; ++pass) {
        bool exact = false;
        sum.add(estimate(i, hashBits(hashBits(settings.seed + i) + static_cast<std::uint64_t>(pass)), &exact));
        sum.exact = exact;
        if (exact) break;
        if (pass + 1 >= settings.leastPasses && sum.toneMappedVariance(offsetOf(i)) < target) break;
      }
    }
    const std::lock_guard<std::mutex> lock(reporting);
    done += static_cast<double>(range.size());
    if (progress && !stopped && !progress(done / static_cast<double>(count))) stopped = true;
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64), work, tbb::simple_partitioner());
  TruthColors result;
  result.complete = !stopped;
  double variance = 0.0, passes = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    result.color.push_back(offsetOf(i) + sums[i].mean);
    variance += sums[i].toneMappedVariance(offsetOf(i));
    passes += sums[i].passes;
  }
  result.standardError = std::sqrt(variance / static_cast<double>(std::max<std::size_t>(count, 1)));
  result.raysPerPixel = settings.raysPerPass * passes / static_cast<double>(std::max<std::size_t>(count, 1));
  return result;
}

}  // namespace

TruthColors boxTruth(const std::vector<BenchPixel>& pixels, const ReferenceBoxMaps& maps, const TruthSettings& settings,
                     const ReferenceProgress& progress) {
  const auto estimate = [&](std::size_t i, std::uint64_t seed, bool* exact) {
    return referenceBoxColor(pixels[i].point, maps, settings.raysPerPass, seed, exact);
  };
  return estimated(pixels.size(), {}, settings, estimate, progress);
}

TruthColors sceneTruth(const std::vector<BenchPixel>& pixels, const TruthColors& box, const ReferenceBoxMaps& maps,
                       const ReferenceScene& scene, const TruthSettings& settings, const ReferenceProgress& progress) {
  const auto estimate = [&](std::size_t i, std::uint64_t seed, bool* exact) {
    const LitPoint& e = pixels[i].point;
    *exact = true;
    glm::dvec3 sum(0.0);
    const auto hit = scene.tracer().firstHit(e.surface.eyeWorld, e.surface.positionWorld - e.surface.eyeWorld);
    if (!hit) return sum;
    const glm::dvec3 away = scene.tracer().awayFrom(*hit);
    const BoxSurroundings surroundings(e, maps);
    for (const ReflectingLayer& layer : reflectingLayers(e.surface, scene.light().energy())) {
      const VisibleNormalLobe lobe = layer.lobe(glm::normalize(glm::dvec3(e.surface.viewWorld)));
      *exact = *exact && lobe.mirror();
      const auto difference = [&](const glm::dvec3& l) {
        // Largest at the outlines of lamps, which the capture represents by texels: sampled by rays towards them.
        BoxSurroundings::Light light;
        light.bright = scene.seenFrom(away, l, RaySees::Probes) - surroundings.radiance(l);
        return light;
      };
      sum += surroundings.reflectedOf(difference, lobe, layer, settings.raysPerPass, seed);
      seed = hashBits(seed);
    }
    return sum;
  };
  TruthColors result = estimated(pixels.size(), box.color, settings, estimate, progress);
  result.standardError = std::hypot(result.standardError, box.standardError);
  return result;
}

}  // namespace boxprobe
