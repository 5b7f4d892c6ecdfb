#include "filters/reference/bench/bench_result.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

namespace {

/// Combines mean squares.
struct Pool {
  double squares = 0.0, relativeSquares = 0.0, truthSquares = 0.0, flip = 0.0, lookups = 0.0, pixels = 0.0;

  void add(const BenchRow& row) {
    const auto n = static_cast<double>(row.pixels);
    squares += n * row.error * row.error;
    relativeSquares += n * row.meanTruthSquare * row.relativeRmse * row.relativeRmse;
    truthSquares += n * row.meanTruthSquare;
    flip += n * row.flip;
    lookups += n * row.lookups;
    pixels += n;
  }
  double error() const { return pixels > 0.0 ? std::sqrt(squares / pixels) : 0.0; }
};

double offBy(const EnergyBucket& bucket) {
  return std::abs(bucket.brightnessRatio - 1.0);
}

BenchSummary summary(const BenchResult& result, Truth truth, std::size_t technique) {
  BenchSummary s;
  s.technique = technique;
  s.truth = truth;
  Pool all;
  std::map<double, Pool> byRoughness;
  std::map<SurfaceKind, Pool> bySurface;
  for (const BenchRow& row : result.rows) {
    if (row.technique != technique || row.truth != truth) continue;
    all.add(row);
    byRoughness[row.roughness].add(row);
    bySurface[row.surface].add(row);
  }
  s.error = all.error();
  s.relativeRmse = all.truthSquares > 0.0 ? std::sqrt(all.relativeSquares / all.truthSquares) : 0.0;
  s.flip = all.pixels > 0.0 ? all.flip / all.pixels : 0.0;
  s.lookups = all.pixels > 0.0 ? all.lookups / all.pixels : 0.0;
  for (const auto& [roughness, pool] : byRoughness) s.errorByRoughness[roughness] = pool.error();
  for (const auto& [kind, pool] : bySurface) s.errorBySurface[kind] = pool.error();

  double light = 0.0, pixels = 0.0;
  for (const EnergyBucket& bucket : result.energy) {
    if (bucket.technique != technique || bucket.truth != truth) continue;
    light += static_cast<double>(bucket.pixels) * bucket.brightnessRatio;
    pixels += static_cast<double>(bucket.pixels);
    if (bucket.pixels < kLeastBucketPixels) continue;
    if (s.worstEnergy.pixels == 0 || offBy(bucket) > offBy(s.worstEnergy)) s.worstEnergy = bucket;
  }
  s.brightnessRatio = pixels > 0.0 ? light / pixels : 1.0;

  std::vector<bench::Samples> cpu, gpu;
  for (const FrameCost& cost : result.costs) {
    if (cost.technique != technique) continue;
    cpu.push_back(cost.cpuSeconds);
    if (!cost.gpuSeconds.a.empty()) gpu.push_back(cost.gpuSeconds);
  }
  s.cpuRatioToBox = bench::meanRatioOfMedians(cpu);
  std::vector<bench::Samples> plain;
  for (const PlainFrameCost& cost : result.plainCosts) plain.push_back(cost.cpuSeconds);
  const double without = plain.empty() ? std::nan("") : bench::meanRatioOfMedians(plain).value;
  s.ownCpuRatioToBox = (s.cpuRatioToBox.value - without) / (1.0 - without);
  if (!gpu.empty()) s.gpuRatioToBox = bench::meanRatioOfMedians(gpu);
  return s;
}

}  // namespace

double roundedTo(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::isfinite(value) ? std::round(value * scale) / scale : value;
}

const char* truthName(Truth truth) {
  return truth == Truth::Box ? "box" : "scene";
}

const char* surfaceKindName(SurfaceKind kind) {
  return kind == SurfaceKind::Smooth ? "smooth" : "normal-mapped";
}

std::vector<BenchSummary> summaries(const BenchResult& result, Truth truth) {
  std::vector<BenchSummary> list;
  for (std::size_t i = 0; i < result.techniques.size(); ++i) list.push_back(summary(result, truth, i));
  for (const BenchSummary& baseline : list) {
    const BenchTechnique& technique = result.techniques[baseline.technique];
    if (technique.id != kErrorBaseline || !technique.parameters.empty() || !(baseline.error > 0.0)) continue;
    for (BenchSummary& s : list) s.errorRatioToHdrp = s.error / baseline.error;
  }
  std::vector<ParetoPoint> points;
  for (const BenchSummary& s : list) {
    points.push_back(
        {{}, {}, roundedTo(s.cpuRatioToBox.value, kCostDigits), roundedTo(s.error, kErrorDigits), false, false});
  }
  markParetoFront(points);
  for (std::size_t i = 0; i < list.size(); ++i) list[i].onParetoFront = points[i].onParetoFront;
  return list;
}

std::vector<ParetoPoint> paretoPoints(const BenchResult& result, Truth truth) {
  std::vector<ParetoPoint> points;
  for (const BenchSummary& s : summaries(result, truth)) {
    const BenchTechnique& technique = result.techniques[s.technique];
    points.push_back(
        {technique.id, technique.label(), s.cpuRatioToBox.value, s.error, s.onParetoFront, technique.ours});
  }
  return points;
}

}  // namespace boxprobe
