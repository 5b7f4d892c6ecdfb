// Run time against error of every technique, measured: what to measure, and the run itself. Called by the command line
// with a host that renders, times and explains; knows no renderer.
#pragma once

#include <functional>

#include "filters/reference/bench/bench_result.h"
#include "filters/reference/bench/bench_surfaces.h"
#include "filters/reference/bench/bench_truth.h"

namespace boxprobe {

struct BenchPlan {
  std::vector<BenchTechnique> techniques;
  std::vector<Camera> cameras;  ///< frames are timed through the first
  std::vector<double> roughnesses;
  std::vector<std::string> materials;  ///< only pixels that show one of these are measured; empty: of all that reflect
  int width = 200, height = 112;
  TruthSettings boxTruth, sceneTruth;
  int lookupPixels = 24;  ///< whose fetches are counted, for each technique and view
  int leastPairs = 3;     ///< of frames, technique and baseline in turn, at each roughness
  int mostPairs = 9;
  double pairSeconds = 0.6;  ///< CPU time after which a technique has had enough pairs
  std::uint64_t seed = 1;
  StudyPlan study;
};

/// Seconds of one frame; gpu is empty where the driver does not draw on a device of its own.
struct FrameSeconds {
  double cpu = 0.0;
  std::optional<double> gpu;
};

/// What the benchmark asks of a renderer. `scene` is the same object for all calls of one roughness, techniques apart.
class BenchHost {
 public:
  virtual ~BenchHost() = default;
  /// Every pixel of the picture, rows from the top.
  virtual std::vector<LitPoint> surfaces(const Scene& scene, const Camera& camera, int width, int height) = 0;
  /// The capture that the picture above was explained with.
  virtual ReferenceBoxMaps maps(const Scene& scene) = 0;
  /// Linear, one sample in the middle of each pixel: the points that surfaces() explains.
  virtual ImageRgbaF picture(const Scene& scene, const Camera& camera, int width, int height) = 0;
  /// Mean count of fetches of the pixels `places`.
  virtual double lookups(const Scene& scene, const Camera& camera, int width, int height,
                         const std::vector<glm::ivec2>& places) = 0;
  /// Both scenes ready to be timed in turn by frame(), which draws the first or the second.
  virtual void prepareFrames(const Scene& technique, const Scene& baseline, const Camera& camera) = 0;
  /// The same with a frame without any reflection of probes in place of the technique's.
  virtual void preparePlainFrames(const Scene& baseline, const Camera& camera) = 0;
  virtual FrameSeconds frame(bool technique) = 0;
  /// The scene as the tracer sees it.
  virtual const ReferenceScene& tracedScene(const Scene& scene) = 0;
};

/// What the contact sheet shows, of one view.
struct BenchPictures {
  const Camera* camera = nullptr;
  double roughness = 0.0;
  const BenchTechnique* technique = nullptr;  ///< null: the truth itself
  const ImageRgbaF* picture = nullptr;
  const ImageRgbaF* truth = nullptr;  ///< the picture with the box truth at the pixels that count
  const std::vector<bool>* mask = nullptr;
};
using BenchPictureSink = std::function<void(const BenchPictures&)>;

/// `progress` returning false stops it: the result is then not complete. `scene`: as loaded. Throws InputError for a
/// scene without a probe, or without a reflecting surface that any camera sees within one.
BenchResult runBenchmark(const BenchPlan& plan, const Scene& scene,
                         const std::vector<std::shared_ptr<const Model>>& models, BenchHost& host,
                         const ReferenceProgress& progress, const BenchPictureSink& sink = {});

}  // namespace boxprobe
