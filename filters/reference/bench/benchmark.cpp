#include "filters/reference/bench/benchmark.h"

#include <algorithm>
#include <cmath>

#include "filters/core/base/errors.h"
#include "filters/reference/bench/bench_noise.h"
#include "filters/reference/measure/error_tally.h"
#include "filters/reference/measure/flip.h"
#include "filters/reference/measure/metrics.h"

namespace boxprobe {

namespace {

constexpr int kAngleBuckets = 4;  ///< equal parts of N.V

/// Relative durations, for the estimate of the time left; measured on two cores.
constexpr double kTruthSteps = 12.0, kPictureSteps = 0.5, kFrameSteps = 2.0, kStudySteps = 40.0;

struct Stopped {};

class Run {
 public:
  Run(const BenchPlan& plan, const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
      BenchHost& host, const ReferenceProgress& progress, const BenchPictureSink& sink)
      : plan_(plan),
        scene_(scene),
        host_(host),
        progress_(progress),
        sink_(sink),
        materials_(reflectingMaterials(scene, models)) {
    const auto views = static_cast<double>(plan.cameras.size() * plan.roughnesses.size());
    const auto techniques = static_cast<double>(plan.techniques.size());
    steps_ = views * (kTruthSteps + kPictureSteps * techniques) +
             static_cast<double>(plan.roughnesses.size()) * (techniques + 1.0) * kFrameSteps + kStudySteps;
    result_.width = plan.width;
    result_.height = plan.height;
    result_.seed = plan.seed;
    result_.techniques = plan.techniques;
    result_.roughnesses = plan.roughnesses;
    for (const Camera& camera : plan.cameras) result_.cameras.push_back(camera.name);
    result_.timedCamera = plan.cameras.front().name;
    if (scene.probes.empty()) throw InputError("the scene has no probe: there is no reflection to measure; add one");
    if (materials_.empty()) {
      throw InputError(
          "the scene has no reflecting surface: every material is unlit or diffuse; give one a roughness below 0.5 or "
          "metallic 1");
    }
    measured_ = onlyMaterials(materials_, plan.materials);
  }

  BenchResult run() {
    try {
      for (const Camera& camera : plan_.cameras) {
        for (const double roughness : plan_.roughnesses) measureView(camera, roughness);
      }
      if (result_.rows.empty()) {
        throw InputError("no camera sees a reflecting surface within a probe's influence: nothing can be measured");
      }
      for (const double roughness : plan_.roughnesses) timeFrames(roughness);
      result_.study =
          runStudy(plan_.study, plan_.techniques, [&](double share) { return report(kStudySteps * share); });
      check();
      result_.complete = true;
    } catch (const Stopped&) {
    }
    addEnergy();
    return std::move(result_);
  }

 private:
  void step(double share) {
    done_ += share;
    report(0.0);
  }
  bool report(double within) { return !progress_ || progress_(std::min((done_ + within) / steps_, 1.0)); }
  void check() {
    if (!report(0.0)) throw Stopped();
  }

  void measureView(const Camera& camera, double roughness);
  void measureTechnique(std::size_t index, const Camera& camera, double roughness, const Scene& base);
  void timeFrames(double roughness);
  void timePairs(bench::Samples& cpu, bench::Samples& gpu);
  void addEnergy();
  std::vector<glm::ivec2> lookupPlaces() const;

  const BenchPlan& plan_;
  const Scene& scene_;
  BenchHost& host_;
  const ReferenceProgress& progress_;
  const BenchPictureSink& sink_;
  std::map<std::string, SurfaceKind> materials_;  ///< all that reflect
  std::map<std::string, SurfaceKind> measured_;   ///< those that are measured
  BenchResult result_;
  double steps_ = 1.0, done_ = 0.0;

  // State of the view that is being measured:
  std::vector<BenchPixel> pixels_;
  std::map<SurfaceKind, std::vector<bool>> masks_;
  std::vector<bool> mask_;
  std::map<Truth, TruthColors> truth_;

  struct Light {
    double sum = 0.0, truth = 0.0;
    std::size_t pixels = 0;
  };
  /// By technique, reference, roughness and bucket of N.V.
  std::map<std::tuple<std::size_t, Truth, double, int>, Light> light_;
};

void Run::measureView(const Camera& camera, double roughness) {
  check();
  const Scene base = withTechnique(withRoughness(scene_, materials_, roughness), {kCostBaseline, {}, false});
  pixels_ = measuredPixels(host_.surfaces(base, camera, plan_.width, plan_.height), plan_.width, measured_);
  if (pixels_.empty()) {
    const std::string remark = "camera " + camera.name + ": sees no reflecting surface within a probe's influence";
    if (std::find(result_.remarks.begin(), result_.remarks.end(), remark) == result_.remarks.end()) {
      result_.remarks.push_back(remark);
    }
    step(kTruthSteps + kPictureSteps * static_cast<double>(plan_.techniques.size()));
    return;
  }
  const auto count = static_cast<std::size_t>(plan_.width) * static_cast<std::size_t>(plan_.height);
  mask_.assign(count, false);
  for (const SurfaceKind kind : kSurfaceKinds) masks_[kind].assign(count, false);
  for (const BenchPixel& pixel : pixels_) {
    mask_[pixel.index] = true;
    masks_[pixel.kind][pixel.index] = true;
  }
  ReferenceBoxMaps maps = host_.maps(base);
  maps.findBright();
  truth_[Truth::Box] =
      boxTruth(pixels_, maps, plan_.boxTruth, [&](double share) { return report(0.6 * kTruthSteps * share); });
  step(0.6 * kTruthSteps);
  if (!truth_[Truth::Box].complete) throw Stopped();
  truth_[Truth::Scene] = sceneTruth(pixels_, truth_[Truth::Box], maps, host_.tracedScene(base), plan_.sceneTruth,
                                    [&](double share) { return report(0.4 * kTruthSteps * share); });
  step(0.4 * kTruthSteps);
  if (!truth_[Truth::Scene].complete) throw Stopped();
  for (const Truth truth : kTruths) {
    const TruthColors& colors = truth_[truth];
    result_.truthNoise.push_back({camera.name, roughness, truth, colors.standardError, colors.raysPerPixel});
  }
  const std::size_t firstRow = result_.rows.size();
  for (std::size_t i = 0; i < plan_.techniques.size(); ++i) {
    check();
    measureTechnique(i, camera, roughness, base);
    step(kPictureSteps);
  }
  // Relative to the baseline's error in the same view.
  for (std::size_t i = firstRow; i < result_.rows.size(); ++i) {
    BenchRow& row = result_.rows[i];
    for (std::size_t k = firstRow; k < result_.rows.size(); ++k) {
      const BenchRow& other = result_.rows[k];
      if (plan_.techniques[other.technique].id != kErrorBaseline || other.surface != row.surface ||
          other.truth != row.truth || !plan_.techniques[other.technique].parameters.empty())
        continue;
      // In a mirror the baseline may be exact.
      row.errorRatioToHdrp = other.error > 0.0 ? row.error / other.error : row.error > 0.0 ? std::nan("") : 1.0;
    }
  }
}

std::vector<glm::ivec2> Run::lookupPlaces() const {
  std::vector<glm::ivec2> places;
  const auto wanted = static_cast<std::size_t>(std::max(plan_.lookupPixels, 2));
  for (std::size_t k = 0; k < wanted; ++k) {
    const auto index = static_cast<int>(pixels_[k * (pixels_.size() - 1) / (wanted - 1)].index);
    places.emplace_back(index % plan_.width, index / plan_.width);
  }
  return places;
}

void Run::measureTechnique(std::size_t index, const Camera& camera, double roughness, const Scene& base) {
  const BenchTechnique& technique = plan_.techniques[index];
  const Scene scene = withTechnique(base, technique);
  ImageRgbaF picture = host_.picture(scene, camera, plan_.width, plan_.height);
  check();
  const double lookups = host_.lookups(scene, camera, plan_.width, plan_.height, lookupPlaces());
  for (const Truth truth : kTruths) {
    check();
    // Equal elsewhere, so that filters of the metrics carry no difference in from there.
    ImageRgbaF right = picture;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        right.pixels[4 * pixels_[i].index + c] = static_cast<float>(truth_[truth].color[i][static_cast<int>(c)]);
      }
    }
    if (sink_ && truth == Truth::Box) sink_({&camera, roughness, &technique, &picture, &right, &mask_});
    const std::vector<float> flip = flipMap(picture, right);
    std::map<SurfaceKind, ErrorTally> tallies;
    std::map<SurfaceKind, std::vector<float>> errors;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const BenchPixel& pixel = pixels_[i];
      const float* drawn = &picture.pixels[4 * pixel.index];
      const glm::dvec3 value(drawn[0], drawn[1], drawn[2]), wanted = truth_[truth].color[i];
      ErrorTally& tally = tallies[pixel.kind];
      tally.add(value, wanted, flip[pixel.index]);
      if (technique.sampled()) {
        std::vector<float>& error = errors[pixel.kind];
        error.resize(mask_.size());
        error[pixel.index] = static_cast<float>((toneMapped(value.x) + toneMapped(value.y) + toneMapped(value.z) -
                                                 toneMapped(wanted.x) - toneMapped(wanted.y) - toneMapped(wanted.z)) /
                                                3.0);
      }
      // For the reflection alone: common terms would hide a loss of light.
      const LitPoint& e = pixel.point;
      const glm::dvec3 common(e.direct + e.emissive + e.diffuse);
      const int bucket = std::min(static_cast<int>(e.nDotV * kAngleBuckets), kAngleBuckets - 1);
      Light& light = light_[{index, truth, roughness, bucket}];
      for (int c = 0; c < 3; ++c) {
        light.sum += value[c] - common[c];
        light.truth += wanted[c] - common[c];
      }
      ++light.pixels;
    }
    for (const auto& [kind, tally] : tallies) {
      BenchRow row;
      row.technique = index;
      row.camera = camera.name;
      row.roughness = roughness;
      row.surface = kind;
      row.truth = truth;
      row.pixels = tally.pixels();
      row.error = tally.toneMappedRmse();
      row.relativeRmse = tally.relativeRmse();
      row.meanTruthSquare = tally.meanTruthSquare();
      row.flip = tally.flip();
      row.brightnessRatio = tally.brightnessRatio();
      row.lookups = lookups;
      if (technique.sampled()) row.noise = noiseFigures(errors[kind], masks_[kind], plan_.width, plan_.height);
      result_.rows.push_back(row);
    }
  }
}

void Run::timeFrames(double roughness) {
  const Scene base = withTechnique(withRoughness(scene_, materials_, roughness), {kCostBaseline, {}, false});
  for (std::size_t i = 0; i < plan_.techniques.size(); ++i) {
    check();
    FrameCost cost;
    cost.technique = i;
    cost.roughness = roughness;
    host_.prepareFrames(withTechnique(base, plan_.techniques[i]), base, plan_.cameras.front());
    timePairs(cost.cpuSeconds, cost.gpuSeconds);
    result_.costs.push_back(std::move(cost));
    step(kFrameSteps);
  }
  check();
  PlainFrameCost plain;
  plain.roughness = roughness;
  bench::Samples gpu;
  host_.preparePlainFrames(base, plan_.cameras.front());
  timePairs(plain.cpuSeconds, gpu);
  result_.plainCosts.push_back(std::move(plain));
  step(kFrameSteps);
}

void Run::timePairs(bench::Samples& cpu, bench::Samples& gpu) {
  double spent = 0.0;
  for (int pair = 0; pair < plan_.mostPairs && (pair < plan_.leastPairs || spent < plan_.pairSeconds); ++pair) {
    check();
    FrameSeconds of[2];
    for (const bool technique : {pair % 2 == 0, pair % 2 != 0}) of[technique ? 0 : 1] = host_.frame(technique);
    cpu.a.push_back(of[0].cpu);
    cpu.b.push_back(of[1].cpu);
    if (of[0].gpu && of[1].gpu) {
      gpu.a.push_back(*of[0].gpu);
      gpu.b.push_back(*of[1].gpu);
    }
    spent += of[0].cpu + of[1].cpu;
  }
}

void Run::addEnergy() {
  for (const auto& [key, light] : light_) {
    const auto& [technique, truth, roughness, bucket] = key;
    EnergyBucket entry;
    entry.technique = technique;
    entry.truth = truth;
    entry.roughness = roughness;
    entry.nDotVLow = static_cast<double>(bucket) / kAngleBuckets;
    entry.nDotVHigh = static_cast<double>(bucket + 1) / kAngleBuckets;
    entry.brightnessRatio = light.truth > 0.0 ? light.sum / light.truth : 1.0;
    entry.pixels = light.pixels;
    result_.energy.push_back(entry);
  }
}

}  // namespace

BenchResult runBenchmark(const BenchPlan& plan, const Scene& scene,
                         const std::vector<std::shared_ptr<const Model>>& models, BenchHost& host,
                         const ReferenceProgress& progress, const BenchPictureSink& sink) {
  return Run(plan, scene, models, host, progress, sink).run();
}

}  // namespace boxprobe
