// See reference_trace.h.
#include "app/gui/view/reference_trace.h"

#include <QMetaObject>
#include <algorithm>
#include <cmath>
#include <exception>

#include "app/session/load_scene.h"
#include "filters/reference/light/reference_scene.h"

namespace boxprobe {

namespace {

/// Coarse at once, fine later.
struct TracePass {
  int divisor;  ///< of the picture's size
  int rays;
};
constexpr TracePass kTracePasses[] = {{8, 8}, {4, 16}, {2, 32}, {1, 64}, {1, 256}};

QImage displayImage(const ImageRgbaF& linear, double exposure) {
  QImage image(linear.width, linear.height, QImage::Format_RGB32);
  std::size_t at = 0;
  for (int y = 0; y < linear.height; ++y) {
    auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < linear.width; ++x, at += 4) {
      const auto shown = [&](std::size_t channel) {
        const double value = std::clamp(exposure * static_cast<double>(linear.pixels[at + channel]), 0.0, 1.0);
        return static_cast<int>(std::lround(255.0 * std::pow(value, 1.0 / 2.2)));
      };
      row[x] = qRgb(shown(0), shown(1), shown(2));
    }
  }
  return image;
}

}  // namespace

ReferenceTrace::~ReferenceTrace() {
  end();
}

void ReferenceTrace::end() {
  stop_ = true;
  ++run_;
  if (thread_.joinable()) thread_.join();
  stop_ = false;
}

void ReferenceTrace::start(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                           const Camera& camera, const QSize& size) {
  end();
  thread_ = std::thread([this, run = run_, scene, models, camera, size] {
    const auto tell = [this, run](const QImage& image, double share, const QString& error) {
      QMetaObject::invokeMethod(
          this, [this, image, share, error, run] { passDone(image, share, error, run); }, Qt::QueuedConnection);
    };
    try {
      const ReferenceScene reference(scene, models, loadSkyImage(scene));
      std::size_t done = 0;
      for (const TracePass& pass : kTracePasses) {
        ReferenceSettings settings;
        settings.width = std::max(size.width() / pass.divisor, 1);
        settings.height = std::max(size.height() / pass.divisor, 1);
        settings.samplesPerPixel = 1;
        settings.raysPerPixel = pass.rays;
        const ReferencePicture picture = reference.render(camera, settings, [this](double) { return !stop_; });
        if (stop_ || !picture.complete) return;
        ++done;
        const QImage image = displayImage(picture.color, scene.exposure);
        tell(image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation),
             static_cast<double>(done) / static_cast<double>(std::size(kTracePasses)), {});
      }
    } catch (const std::exception& caught) {
      tell({}, 0.0, QString::fromUtf8(caught.what()));
    }
  });
}

void ReferenceTrace::passDone(const QImage& picture, double share, const QString& error, int run) {
  if (run != run_) return;
  if (!error.isEmpty()) return emit failed(error);
  if (share >= 1.0) end();
  emit traced(picture, share);
}

}  // namespace boxprobe
