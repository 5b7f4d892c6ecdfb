// See scene_review.h.
#include "app/session/scene_review.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/automatic_exposure.h"
#include "app/session/offscreen_scene.h"
#include "filters/fit/fit_probe.h"
#include "filters/reference/bench/bench_surfaces.h"
#include "filters/reference/path/reference_path.h"
#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

namespace {

std::string nameOf(const LoadedScene& loaded) {
  const std::string path = !loaded.path.empty()           ? loaded.path
                           : !loaded.scene.models.empty() ? loaded.scene.models.front().file
                                                          : std::string("scene");
  return sceneName(path);
}

class Reviewer {
 public:
  Reviewer(LoadedScene loaded, OffscreenScene& shown, const ReviewSettings& settings,
           const std::function<bool(double)>& progress)
      : loaded_(std::move(loaded)), shown_(shown), settings_(settings), progress_(progress) {
    if (settings_.cameras.empty()) settings_.cameras = loaded_.scene.cameras;
    if (settings_.cameras.empty()) settings_.cameras.emplace_back();
    // One renderer may have shown other scenes before.
    facesBefore_ = facesCaptured();
    secondsBefore_ = captureSeconds();
  }

  std::optional<SceneReview> review() {
    review_.name = nameOf(loaded_);
    for (const auto& model : loaded_.models) review_.triangles += model->triangleCount();
    if (!drawAll() || !fitAll()) return std::nullopt;
    review_.scene = loaded_.scene;
    review_.rendererName = shown_.renderer().rendererName();
    for (const std::string& text : loaded_.warnings) review_.remarks.push_back(text);
    for (const std::string& text : shown_.renderer().remarks()) review_.remarks.push_back(text);
    return std::move(review_);
  }

 private:
  // Shares of the time, as they usually are.
  static constexpr double kCapturing = 0.1, kFitting = 0.1;

  bool report(double done) const { return !progress_ || progress_(std::min(done, 1.0)); }

  bool drawAll() {
    const double aspect = static_cast<double>(settings_.width) / settings_.height;
    const auto capture = [this](double from) {
      return shown_.capture([this, from](double done) { return report(from + kCapturing * done); });
    };
    shown_.show(loaded_.scene, loaded_.models, {settings_.cameras.front()});
    if (!capture(0.0)) return false;
    exposeAutomatically(shown_, loaded_, {settings_.cameras.front()}, aspect);
    const ReferencePath path(loaded_.scene, loaded_.models, loadSkyImage(loaded_.scene));
    for (const std::string& remark : path.remarks()) review_.remarks.push_back("path tracer: " + remark);
    const SceneTracer tracer(makeTriangleScene(loaded_.scene, loaded_.models));
    const double each = (1.0 - kCapturing - kFitting) / static_cast<double>(settings_.cameras.size());
    for (const Camera& camera : settings_.cameras) {
      const double from = kCapturing + each * static_cast<double>(review_.cameras.size());
      ReviewedCamera row;
      row.camera = camera;
      PathSettings traced;
      traced.width = settings_.width;
      traced.height = settings_.height;
      traced.raysPerPixel = settings_.paths;
      traced.seed = settings_.seed;
      row.truth = path.render(camera, traced, [&](double done) { return report(from + each * done); });
      if (!row.truth.complete) return false;
      shown_.show(loaded_.scene, loaded_.models, {camera});
      if (!capture(from + each)) return false;
      row.picture = shown_.renderer().renderLinear(settings_.width, settings_.height, settings_.samplesPerPixel);
      row.lookups = shown_.renderer().measureLookups(settings_.width, settings_.height);
      shown_.requireHealthy();
      row.parts = partErrors(row.picture, row.truth,
                             seenPoints(loaded_.scene, tracer, camera, settings_.width, settings_.height));
      review_.cameras.push_back(std::move(row));
    }
    review_.faces = facesCaptured() - facesBefore_;
    review_.captureCpuSeconds = captureSeconds() - secondsBefore_;
    return true;
  }

  std::uint64_t facesCaptured() const {
    std::uint64_t faces = 0;
    for (const BounceCost& bounce : shown_.renderer().times().bounces) faces += bounce.faces;
    return faces;
  }
  double captureSeconds() const {
    const Times& times = shown_.renderer().times();
    return times.captureCpuSeconds + times.prefilterCpuSeconds;
  }

  bool fitAll() {
    shown_.show(loaded_.scene, loaded_.models, {settings_.cameras.front()});
    shown_.timedFrame();
    const FrameReport frame = shown_.renderer().frameReport();
    const std::vector<Probe>& probes = loaded_.scene.probes;
    if (probes.empty()) return true;
    ProbeFitter fitter(loaded_.scene, loaded_.models);
    for (std::size_t i = 0; i < probes.size(); ++i) {
      ReviewedProbe row;
      row.probe = probes[i];
      for (const FrameReport::ProbeUse& use : frame.probes) {
        if (use.name == row.probe.name) row.bytes = use.bytes, row.objects = use.objects;
      }
      if (row.probe.mode != ProbeMode::Custom) {
        row.fit = fitter.fit(row.probe, {}, [&](double done) {
          return report(1.0 - kFitting +
                        kFitting * (static_cast<double>(i) + done) / static_cast<double>(probes.size()));
        });
        if (!row.fit) return false;
      }
      review_.probes.push_back(std::move(row));
    }
    return true;
  }

  LoadedScene loaded_;
  OffscreenScene& shown_;
  ReviewSettings settings_;
  const std::function<bool(double)>& progress_;
  SceneReview review_;
  std::uint64_t facesBefore_ = 0;
  double secondsBefore_ = 0.0;
};

}  // namespace

double SceneReview::worstError() const {
  double worst = 0.0;
  for (const ReviewedCamera& row : cameras) {
    if (!(row.all().relativeRmse <= worst)) worst = row.all().relativeRmse;  // what is not a number stays
    if (std::isnan(worst)) break;
  }
  return worst;
}

std::optional<SceneReview> reviewScene(LoadedScene loaded, OffscreenScene& shown, const ReviewSettings& settings,
                                       const std::function<bool(double)>& progress) {
  return Reviewer(std::move(loaded), shown, settings, progress).review();
}

}  // namespace boxprobe
