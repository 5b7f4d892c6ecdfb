// The results of a benchmark run: measured by runBenchmark, written to bench.json, bench.csv and report.md, drawn in
// the chart.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/picture/pareto_front.h"
#include "filters/reference/measure/interleaved.h"
#include "filters/reference/study/bench_technique.h"
#include "filters/reference/study/study.h"

namespace boxprobe {

/// What a technique is compared with.
enum class Truth {
  Box,    ///< the integral over the probe's box: leaves only the evaluation's error
  Scene,  ///< the traced scene: includes the box's error
};
inline constexpr std::array<Truth, 2> kTruths = {Truth::Box, Truth::Scene};
const char* truthName(Truth truth);  ///< "box", "scene"

/// Shading normals that follow the geometry, or that a texture perturbs per pixel.
enum class SurfaceKind { Smooth, NormalMapped };
inline constexpr std::array<SurfaceKind, 2> kSurfaceKinds = {SurfaceKind::Smooth, SurfaceKind::NormalMapped};
const char* surfaceKindName(SurfaceKind kind);  ///< "smooth", "normal-mapped"

/// Noise of a technique that draws rays at random, over the pixels of a row.
struct NoiseFigures {
  /// Share of the error's power spectrum below an eighth of a cycle per pixel: 0.049 for white noise, less for fine
  /// grain, near 1 for an error that is not noise.
  double lowFrequencyShare = 0.0;
  double errorAfterBlur = 0.0;  ///< tone-mapped RMSE of the error blurred by 3 x 3 pixels
};

/// One technique with one camera at one roughness on one kind of surface, against one reference.
struct BenchRow {
  std::size_t technique = 0;  ///< index into BenchResult::techniques
  std::string camera;
  double roughness = 0.0;
  SurfaceKind surface = SurfaceKind::Smooth;
  Truth truth = Truth::Box;
  std::size_t pixels = 0;
  double error = 0.0;  ///< RMSE of (x / (1 + x))^(1/2.2)
  double relativeRmse = 0.0;
  double meanTruthSquare = 0.0;  ///< the base of relativeRmse: the weight of the row in means
  double flip = 0.0;
  double brightnessRatio = 1.0;
  double errorRatioToHdrp = 0.0;  ///< NaN where hdrp is exact and this technique is not
  double lookups = 0.0;           ///< cubemap lookups per pixel
  std::optional<NoiseFigures> noise;
};

/// Mean brightness relative to the reference's, for pixels with similar view angles, over all cameras and surfaces.
struct EnergyBucket {
  std::size_t technique = 0;
  Truth truth = Truth::Box;
  double roughness = 0.0;
  double nDotVLow = 0.0, nDotVHigh = 1.0;
  double brightnessRatio = 1.0;
  std::size_t pixels = 0;
};

/// The time of a frame at one roughness, relative to plain box projection drawn in alternation.
struct FrameCost {
  std::size_t technique = 0;
  double roughness = 0.0;
  bench::Samples cpuSeconds;  ///< a: the technique's, b: plain box projection's
  bench::Samples gpuSeconds;  ///< empty if the driver draws on the CPU
};

/// The time of a frame without probe reflections at one roughness, which is independent of the technique.
struct PlainFrameCost {
  double roughness = 0.0;
  bench::Samples cpuSeconds;  ///< a: without reflections, b: plain box projection's
};

/// The error of a reference itself.
struct TruthNoise {
  std::string camera;
  double roughness = 0.0;
  Truth truth = Truth::Box;
  double standardError = 0.0;  ///< RMS over tone-mapped values
  double raysPerPixel = 0.0;
};

/// One technique against one reference, over all measurements.
struct BenchSummary {
  std::size_t technique = 0;
  Truth truth = Truth::Box;
  double error = 0.0;  ///< RMS over the pixels of all rows
  double relativeRmse = 0.0;
  double flip = 0.0;
  double errorRatioToHdrp = 0.0;
  double brightnessRatio = 1.0;
  std::map<double, double> errorByRoughness;
  std::map<SurfaceKind, double> errorBySurface;
  double lookups = 0.0;
  bench::Ratio cpuRatioToBox;  ///< mean over the roughnesses with equal weights
  /// Its time above a frame without reflections, relative to that of plain box projection; NaN if that was not
  /// measured.
  double ownCpuRatioToBox = 0.0;
  std::optional<bench::Ratio> gpuRatioToBox;  ///< the same by the GPU's timer
  EnergyBucket worstEnergy;                   ///< among the buckets with enough pixels
  bool onParetoFront = false;
};

struct BenchResult {
  std::string scene;
  std::string machine, glRenderer, glVersion;
  int anisotropy = 1;                   ///< with which surfaces' textures were sampled
  int width = 0, height = 0;            ///< of the pictures in which errors are measured
  int timedWidth = 0, timedHeight = 0;  ///< of the timed frames
  std::string timedCamera;
  std::uint64_t seed = 1;
  std::vector<std::string> cameras;
  std::vector<double> roughnesses;
  std::vector<BenchTechnique> techniques;
  std::vector<BenchRow> rows;
  std::vector<EnergyBucket> energy;
  std::vector<FrameCost> costs;
  std::vector<PlainFrameCost> plainCosts;
  StudyResult study;
  std::vector<TruthNoise> truthNoise;
  std::vector<std::string> remarks;  ///< what was left out, and why
  bool complete = false;
};

/// With fewer pixels a mean is unreliable.
inline constexpr std::size_t kLeastBucketPixels = 200;

/// `value` rounded to that many decimal places; non-finite values are unchanged.
double roundedTo(double value, int digits);
/// For summaries in files.
inline constexpr int kErrorDigits = 6, kCostDigits = 4;

/// One per technique, in the order of the table. `front` is computed from cost and error as rounded in files, so that
/// readers of a file find the same front.
std::vector<BenchSummary> summaries(const BenchResult& result, Truth truth);

/// The points of the chart.
std::vector<ParetoPoint> paretoPoints(const BenchResult& result, Truth truth);

}  // namespace boxprobe
