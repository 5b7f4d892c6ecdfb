// See scene_review.h.
#include "app/session/scene_review.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/automatic_exposure.h"
#include "app/session/offscreen_scene.h"
#include "app/session/shared_work.h"
#include "filters/fit/fit_probe.h"
#include "filters/reference/bench/bench_surfaces.h"
#include "filters/reference/path/reference_path.h"
#include "filters/reference/trace/scene_tracer.h"
#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

namespace {

std::string nameOf(const LoadedScene& loaded) {
  const std::string path = !loaded.path.empty()           ? loaded.path
                           : !loaded.scene.models.empty() ? loaded.scene.models.front().file
                                                          : std::string("scene");
  return sceneName(path);
}

std::vector<Camera> camerasOf(const Scene& scene, const ReviewSettings& settings) {
  std::vector<Camera> cameras = settings.cameras.empty() ? scene.cameras : settings.cameras;
  if (cameras.empty()) cameras.emplace_back();
  return cameras;
}

// Small enough to be shared evenly, high enough that starting one costs nothing.
constexpr int kBandRows = 16;

int bandsOf(const ReviewSettings& settings) {
  return (settings.height + kBandRows - 1) / kBandRows;
}

PathSettings pathsOf(const ReviewSettings& settings) {
  PathSettings traced;
  traced.width = settings.width;
  traced.height = settings.height;
  traced.raysPerPixel = settings.paths;
  traced.seed = settings.seed;
  return traced;
}

/// Rows kBandRows * `band` and on, nothing else: as another process kept them, or traced here and kept.
ReferencePicture tracedBand(const ReferencePath& path, const Camera& camera, std::size_t number, int band,
                            const ReviewSettings& settings, const std::function<bool(double)>& progress) {
  const std::string name = "camera-" + std::to_string(number + 1) + "-band-" + std::to_string(band + 1);
  PathSettings traced = pathsOf(settings);
  traced.part = {0, kBandRows * band, settings.width, std::min(kBandRows * (band + 1), settings.height)};
  const int height = traced.part.bottom - traced.part.top;
  if (auto known = settings.shared->findTraced(name, settings.width, height)) return *std::move(known);
  const ReferencePicture picture = path.render(camera, traced, progress);
  const auto row = 4 * static_cast<std::ptrdiff_t>(settings.width);
  ReferencePicture rows{{settings.width, height, {}}, {}, picture.complete};
  rows.standardError = rows.color;
  for (ImageRgbaF ReferencePicture::*image : {&ReferencePicture::color, &ReferencePicture::standardError}) {
    const std::vector<float>& from = (picture.*image).pixels;
    (rows.*image).pixels.assign(from.begin() + traced.part.top * row, from.begin() + traced.part.bottom * row);
  }
  if (rows.complete) settings.shared->keepTraced(name, rows);
  return rows;
}

/// The whole picture, by bands where several processes share it.
ReferencePicture tracedPicture(const ReferencePath& path, const Camera& camera, std::size_t number,
                               const ReviewSettings& settings, const std::function<bool(double)>& progress) {
  if (settings.shared == nullptr) return path.render(camera, pathsOf(settings), progress);
  ReferencePicture picture{{settings.width, settings.height, {}}, {settings.width, settings.height, {}}, true};
  for (int band = 0; band < bandsOf(settings); ++band) {
    const ReferencePicture rows = tracedBand(path, camera, number, band, settings,
                                             [&](double done) { return progress((band + done) / bandsOf(settings)); });
    picture.complete = rows.complete;
    if (!rows.complete) return picture;
    for (ImageRgbaF ReferencePicture::*image : {&ReferencePicture::color, &ReferencePicture::standardError}) {
      (picture.*image)
          .pixels.insert((picture.*image).pixels.end(), (rows.*image).pixels.begin(), (rows.*image).pixels.end());
    }
  }
  return picture;
}

std::optional<BoxFit> fitOf(ProbeFitter& fitter, const Probe& probe, std::size_t number, const ReviewSettings& settings,
                            const FitProgress& progress) {
  const std::string name = "fit-" + std::to_string(number + 1);
  if (settings.shared != nullptr) {
    if (auto known = settings.shared->find(name, probe)) return known;
  }
  std::optional<BoxFit> fit = fitter.fit(probe, {}, progress);
  if (fit && settings.shared != nullptr) settings.shared->keep(name, *fit);
  return fit;
}

class Reviewer {
 public:
  Reviewer(LoadedScene loaded, OffscreenScene& shown, const ReviewSettings& settings,
           const std::function<bool(double)>& progress)
      : loaded_(std::move(loaded)), shown_(shown), settings_(settings), progress_(progress) {
    settings_.cameras = camerasOf(loaded_.scene, settings_);
    // One renderer may have shown other scenes before.
    facesBefore_ = facesCaptured();
    secondsBefore_ = captureSeconds();
  }

  std::optional<SceneReview> review() {
    review_.name = nameOf(loaded_);
    for (const auto& model : loaded_.models) review_.triangles += model->triangleCount();
    if (!drawAll() || !fitAll()) return std::nullopt;
    review_.scene = loaded_.scene;
    review_.rendererName =
        shown_.renderer().rendererName() + ", anisotropy " + std::to_string(static_cast<int>(textureAnisotropy()));
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
      row.truth = tracedPicture(path, camera, review_.cameras.size(), settings_,
                                [&](double done) { return report(from + each * done); });
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
    if (settings_.shared == nullptr) review_.captureCpuSeconds = captureSeconds() - secondsBefore_;
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
        row.fit = fitOf(fitter, row.probe, i, settings_, [&](double done) {
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

bool reviewShare(const LoadedScene& loaded, const ReviewSettings& settings,
                 const std::function<bool(double)>& progress) {
  const std::vector<Camera> cameras = camerasOf(loaded.scene, settings);
  const std::vector<Probe>& probes = loaded.scene.probes;
  constexpr double kTracing = 0.8;
  const auto report = [&](double done) { return !progress || progress(done); };
  {
    const ReferencePath path(loaded.scene, loaded.models, loadSkyImage(loaded.scene));
    const auto bands = static_cast<std::size_t>(bandsOf(settings));
    for (std::size_t piece = 0; piece < cameras.size() * bands; ++piece) {
      if (!settings.shared->mine(piece)) continue;
      const auto onward = [&](double done) {
        return report(kTracing * (static_cast<double>(piece) + done) / static_cast<double>(cameras.size() * bands));
      };
      const std::size_t camera = piece / bands;
      if (!tracedBand(path, cameras[camera], camera, static_cast<int>(piece % bands), settings, onward).complete) {
        return false;
      }
    }
  }
  std::optional<ProbeFitter> fitter;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (probes[i].mode == ProbeMode::Custom || !settings.shared->mine(i)) continue;
    if (!fitter) fitter.emplace(loaded.scene, loaded.models);
    const auto onward = [&](double done) {
      return report(kTracing + (1.0 - kTracing) * (static_cast<double>(i) + done) / static_cast<double>(probes.size()));
    };
    if (!fitOf(*fitter, probes[i], i, settings, onward)) return false;
  }
  return true;
}

}  // namespace boxprobe
