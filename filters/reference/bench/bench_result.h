// What a run of the benchmark found, as plain values: measured by runBenchmark, written by the writers of bench.json,
// bench.csv and report.md, drawn by the chart. Knows no renderer and no file.
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
  Box,    ///< the integral over the probe's box: what is left is the evaluation's error alone
  Scene,  ///< the traced scene: the box's error is in it
};
inline constexpr std::array<Truth, 2> kTruths = {Truth::Box, Truth::Scene};
const char* truthName(Truth truth);  ///< "box", "scene"

/// Shading normals that follow the geometry, and those that a texture bends from pixel to pixel.
enum class SurfaceKind { Smooth, NormalMapped };
inline constexpr std::array<SurfaceKind, 2> kSurfaceKinds = {SurfaceKind::Smooth, SurfaceKind::NormalMapped};
const char* surfaceKindName(SurfaceKind kind);  ///< "smooth", "normal-mapped"

/// Noise of a technique that draws rays at random, over the pixels of a row.
struct NoiseFigures {
  /// Of the power of the error's spectrum, what lies below an eighth of a cycle a pixel: 0.049 for white noise, less
  /// for noise that hides in fine grain, near 1 for an error that is no noise.
  double lowFrequencyShare = 0.0;
  double errorAfterBlur = 0.0;  ///< tone-mapped RMSE of the error blurred by 3 x 3 pixels
};

/// One technique through one camera at one roughness on one kind of surface, against one truth.
struct BenchRow {
  std::size_t technique = 0;  ///< index into BenchResult::techniques
  std::string camera;
  double roughness = 0.0;
  SurfaceKind surface = SurfaceKind::Smooth;
  Truth truth = Truth::Box;
  std::size_t pixels = 0;
  double error = 0.0;  ///< RMSE of (x / (1 + x))^(1/2.2)
  double relativeRmse = 0.0;
  double meanTruthSquare = 0.0;  ///< what relativeRmse is relative to: rows are weighed by it when put together
  double flip = 0.0;
  double brightnessRatio = 1.0;
  double errorRatioToHdrp = 0.0;  ///< not a number where hdrp is exact and this is not
  double lookups = 0.0;           ///< fetches from cube maps a pixel
  std::optional<NoiseFigures> noise;
};

/// Mean brightness over the truth's, of pixels seen under similar angles, all cameras and surfaces together.
struct EnergyBucket {
  std::size_t technique = 0;
  Truth truth = Truth::Box;
  double roughness = 0.0;
  double nDotVLow = 0.0, nDotVHigh = 1.0;
  double brightnessRatio = 1.0;
  std::size_t pixels = 0;
};

/// Of a frame at one roughness, its time over that of plain box projection drawn in turn with it.
struct FrameCost {
  std::size_t technique = 0;
  double roughness = 0.0;
  bench::Samples cpuSeconds;  ///< a: the technique's, b: plain box's
  bench::Samples gpuSeconds;  ///< empty where the driver draws on the CPU
};

/// Of a frame without any reflection of probes at one roughness: what of a frame's time no technique has a part in.
struct PlainFrameCost {
  double roughness = 0.0;
  bench::Samples cpuSeconds;  ///< a: without, b: plain box's
};

/// How far a truth itself is off.
struct TruthNoise {
  std::string camera;
  double roughness = 0.0;
  Truth truth = Truth::Box;
  double standardError = 0.0;  ///< of tone-mapped values, root mean square
  double raysPerPixel = 0.0;
};

/// A technique against one truth, over everything measured.
struct BenchSummary {
  std::size_t technique = 0;
  Truth truth = Truth::Box;
  double error = 0.0;  ///< root mean square over the pixels of all rows
  double relativeRmse = 0.0;
  double flip = 0.0;
  double errorRatioToHdrp = 0.0;
  double brightnessRatio = 1.0;
  std::map<double, double> errorByRoughness;
  std::map<SurfaceKind, double> errorBySurface;
  double lookups = 0.0;
  bench::Ratio cpuRatioToBox;  ///< mean over the roughnesses, each in equal part
  /// What it adds to a frame without reflections, over what plain box projection adds; not a number where that was not
  /// measured.
  double ownCpuRatioToBox = 0.0;
  std::optional<bench::Ratio> gpuRatioToBox;  ///< the same by the driver's clock
  EnergyBucket worstEnergy;                   ///< of the buckets with enough pixels to judge
  bool onParetoFront = false;
};

struct BenchResult {
  std::string scene;
  std::string machine, glRenderer, glVersion;
  int width = 0, height = 0;            ///< of the pictures that errors are measured in
  int timedWidth = 0, timedHeight = 0;  ///< of the frames that are timed
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

/// Fewer pixels than this say little about a mean.
inline constexpr std::size_t kLeastBucketPixels = 200;

/// `value` to so many decimal places; what is not finite stays.
double roundedTo(double value, int digits);
/// Of summaries in files.
inline constexpr int kErrorDigits = 6, kCostDigits = 4;

/// One a technique, in the order of the table; `front` marked by cost and error as files have them, so that a reader of
/// a file finds the same front.
std::vector<BenchSummary> summaries(const BenchResult& result, Truth truth);

/// The points of the chart.
std::vector<ParetoPoint> paretoPoints(const BenchResult& result, Truth truth);

}  // namespace boxprobe
