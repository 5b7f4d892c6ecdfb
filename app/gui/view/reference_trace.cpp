// See reference_trace.h.
#include "app/gui/view/reference_trace.h"

#include <QMetaObject>
#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>

#include "app/gui/view/display_image.h"
#include "app/session/load_scene.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/scope_exit.h"
#include "filters/core/scene/bounces.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/path/reference_path.h"

namespace boxprobe {

namespace {

/// Coarse at once, fine later.
struct TracePass {
  int divisor;  ///< of the picture's size
  int rays;
};
constexpr TracePass kTracePasses[] = {{8, 8}, {4, 16}, {2, 32}, {1, 64}, {1, 256}};
/// Of diffuse light: its noise is shown as an error.
constexpr TracePass kDiffusePasses[] = {{4, 64}, {2, 64}, {1, 64}, {1, 256}};

}  // namespace

ReferenceTrace::~ReferenceTrace() {
  end();
  for (const auto& run : ending_) run->thread.join();
}

void ReferenceTrace::requestStop() {
  if (run_) run_->stop = true;
}

void ReferenceTrace::end() {
  requestStop();
  ++number_;
  if (run_) ending_.push_back(std::move(run_));
  forgetEnded();
}

void ReferenceTrace::forgetEnded() {
  const auto ended = [](const std::unique_ptr<Run>& run) {
    if (!run->left) return false;
    run->thread.join();  // at once
    return true;
  };
  ending_.erase(std::remove_if(ending_.begin(), ending_.end(), ended), ending_.end());
}

void ReferenceTrace::start(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                           const Camera& camera, const QSize& size, TracedLight light, ProbesDiffuse diffuse) {
  end();
  run_ = std::make_unique<Run>();
  run_->thread = std::thread([this, run = run_.get(), number = number_, scene, models, camera, size, light,
                              diffuse = std::make_shared<const ProbesDiffuse>(std::move(diffuse))] {
    const ScopeExit left([run] { run->left = true; });
    const auto tell = [this, number](const QImage& image, double share, const Light& found, const QString& error) {
      QMetaObject::invokeMethod(
          this, [this, image, share, found, error, number] { passDone(image, share, found, error, number); },
          Qt::QueuedConnection);
    };
    try {
      // One at a time: it takes seconds and the memory of the scene's triangles. Those that were stopped meanwhile
      // leave.
      std::unique_lock<std::mutex> preparing(preparing_);
      if (run->stop) return;
      const auto goesOn = [run](double) { return !run->stop; };
      std::function<ReferencePicture(int, int, int)> render;
      if (light != TracedLight::Reflection) {
        const auto path = std::make_shared<const ReferencePath>(scene, models, loadSkyImage(scene));
        render = [path, &scene, &camera, goesOn, light](int width, int height, int rays) {
          PathSettings settings;
          settings.width = width;
          settings.height = height;
          settings.raysPerPixel = rays;
          if (light == TracedLight::Diffuse) settings.quantity = PathQuantity::DiffuseLight;
          if (!scene.probes.empty()) settings.bounces = mostBounces(scene);
          return path->render(camera, settings, goesOn);
        };
      } else {
        const SceneOfDrawnSky drawn = withDrawnSky(scene);
        const auto reference = std::make_shared<const ReferenceScene>(drawn.scene, models, drawn.skyImage);
        render = [reference, &camera, &diffuse, goesOn](int width, int height, int rays) {
          ReferenceSettings settings;
          settings.width = width;
          settings.height = height;
          settings.samplesPerPixel = 1;
          settings.raysPerPixel = rays;
          settings.diffuse = diffuse;
          return reference->render(camera, settings, goesOn);
        };
      }
      preparing.unlock();
      const bool finer = light == TracedLight::Diffuse;
      const std::vector<TracePass> passes =
          finer ? std::vector<TracePass>(std::begin(kDiffusePasses), std::end(kDiffusePasses))
                : std::vector<TracePass>(std::begin(kTracePasses), std::end(kTracePasses));
      std::size_t done = 0;
      for (const TracePass& pass : passes) {
        const auto picture = std::make_shared<const ReferencePicture>(
            render(std::max(size.width() / pass.divisor, 1), std::max(size.height() / pass.divisor, 1), pass.rays));
        if (run->stop || !picture->complete) return;
        ++done;
        const QImage image = displayImage(picture->color, scene.exposure, scene.tone);
        tell(image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation),
             static_cast<double>(done) / static_cast<double>(passes.size()),
             pass.divisor == 1 || finer ? picture : nullptr, {});
      }
    } catch (const std::exception& caught) {
      tell({}, 0.0, nullptr, QString::fromStdString(messageOf(caught)));
    }
  });
}

void ReferenceTrace::passDone(const QImage& picture, double share, const Light& light, const QString& error,
                              int number) {
  if (number != number_) return;
  if (!error.isEmpty()) return emit failed(error);
  if (share >= 1.0) end();
  emit traced(picture, share, light);
}

}  // namespace boxprobe
