// Measures run time against error of every technique, with a host that renders, times and explains.
#pragma once

#include <functional>

#include "filters/reference/bench/bench_result.h"
#include "filters/reference/bench/bench_surfaces.h"
#include "filters/reference/bench/bench_truth.h"

namespace boxprobe {

struct BenchPlan {
  std::vector<BenchTechnique> techniques;
  std::vector<Camera> cameras;  ///< frames are timed with the first
  std::vector<double> roughnesses;
  std::vector<std::string> materials;  ///< measure only pixels with one of these; empty: all that reflect
  int width = 200, height = 112;
  TruthSettings boxTruth, sceneTruth;
  int lookupPixels = 24;  ///< pixels whose lookups are counted, per technique and view
  int leastPairs = 3;     ///< minimum number of frame pairs (technique and baseline in alternation) per roughness
  int mostPairs = 9;
  double pairSeconds = 0.6;  ///< CPU time after which a technique has enough pairs
  std::uint64_t seed = 1;
  StudyPlan study;
};

/// Seconds of one frame; gpu is empty unless the driver draws on a device of its own.
struct FrameSeconds {
  double cpu = 0.0;
  std::optional<double> gpu;
};

/// What the benchmark needs from a renderer. `scene` is the same object for all calls of one roughness, except for
/// techniques.
class BenchHost {
 public:
  virtual ~BenchHost() = default;
  /// All pixels of the picture, rows from the top.
  virtual std::vector<LitPoint> surfaces(const Scene& scene, const Camera& camera, int width, int height) = 0;
  /// The capture with which the picture above was explained.
  virtual ReferenceBoxMaps maps(const Scene& scene) = 0;
  /// Linear, one sample in the middle of each pixel: the points that surfaces() explains.
  virtual ImageRgbaF picture(const Scene& scene, const Camera& camera, int width, int height) = 0;
  /// The mean number of lookups of the pixels `places`.
  virtual double lookups(const Scene& scene, const Camera& camera, int width, int height,
                         const std::vector<glm::ivec2>& places) = 0;
  /// Prepares both scenes for frame(), which draws the first or the second.
  virtual void prepareFrames(const Scene& technique, const Scene& baseline, const Camera& camera) = 0;
  /// The same, with a frame without probe reflections in place of the technique's.
  virtual void preparePlainFrames(const Scene& baseline, const Camera& camera) = 0;
  virtual FrameSeconds frame(bool technique) = 0;
  /// The scene for the ray tracer.
  virtual const ReferenceScene& tracedScene(const Scene& scene) = 0;
};

/// The pictures of one view in the contact sheet.
struct BenchPictures {
  const Camera* camera = nullptr;
  double roughness = 0.0;
  const BenchTechnique* technique = nullptr;  ///< null: the reference itself
  const ImageRgbaF* picture = nullptr;
  const ImageRgbaF* truth = nullptr;  ///< the picture with the box reference at the measured pixels
  const std::vector<bool>* mask = nullptr;
};
using BenchPictureSink = std::function<void(const BenchPictures&)>;

/// If `progress` returns false, it stops and the result is incomplete. `scene`: as loaded. Throws InputError for a
/// scene without a probe, or without a reflecting surface that a camera sees inside one.
BenchResult runBenchmark(const BenchPlan& plan, const Scene& scene,
                         const std::vector<std::shared_ptr<const Model>>& models, BenchHost& host,
                         const ReferenceProgress& progress, const BenchPictureSink& sink = {});

}  // namespace boxprobe
