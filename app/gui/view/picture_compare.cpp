// See picture_compare.h.
#include "app/gui/view/picture_compare.h"

#include <QMetaObject>
#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/picture_difference.h"
#include "app/session/load_scene.h"
#include "filters/reference/light/reference_scene.h"

namespace boxprobe {

namespace {

constexpr int kRestMilliseconds = 300;

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

PictureCompare::PictureCompare(const Document& document, CompareWipe& wipe, Hooks hooks, QObject* parent)
    : QObject(parent), document_(document), wipe_(wipe), hooks_(std::move(hooks)) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMilliseconds);
  connect(&rest_, &QTimer::timeout, this, &PictureCompare::measure);
}

PictureCompare::~PictureCompare() {
  endThread();
}

void PictureCompare::endThread() {
  stop_ = true;
  ++run_;
  if (thread_.joinable()) thread_.join();
  stop_ = false;
}

void PictureCompare::hold() {
  endThread();
  other_ = hooks_.picture();
  if (other_.isNull()) return;
  camera_ = hooks_.camera();
  size_ = other_.size();
  source_ = Source::Held;
  measured_ = false;
  name_ = tr("Held");
  showOther();
  wipe_.showNumbers({});
  emit activeChanged(true);
  emit message(tr("The picture is held on the right: change something, drag the divider, V flips"));
  rest_.start();
}

void PictureCompare::traceReference() {
  source_ = Source::Reference;
  start();
  if (active()) emit activeChanged(true);
}

// In a thread of its own, each pass finer than the one before it.
void PictureCompare::start() {
  endThread();
  const QImage now = hooks_.picture();
  if (now.isNull()) return stop();
  camera_ = hooks_.camera();
  size_ = now.size();
  measured_ = outdated_ = traced_ = false;
  other_ = now;
  name_ = tr("Ray traced: preparing");
  showOther();
  wipe_.showNumbers({});
  thread_ = std::thread([this, run = run_, scene = document_.scene(), models = hooks_.models(), camera = camera_,
                         size = size_] {
    const auto tell = [this, run](const QImage& image, double share, const QString& error) {
      QMetaObject::invokeMethod(
          this, [this, image, share, error, run] { referenceDone(image, share, error, run); }, Qt::QueuedConnection);
    };
    try {
      const ReferenceScene reference(scene, models, loadSkyImage(scene));
      double done = 0.0;
      for (const TracePass& pass : kTracePasses) {
        ReferenceSettings settings;
        settings.width = std::max(size.width() / pass.divisor, 1);
        settings.height = std::max(size.height() / pass.divisor, 1);
        settings.samplesPerPixel = 1;
        settings.raysPerPixel = pass.rays;
        const ReferencePicture picture = reference.render(camera, settings, [this](double) { return !stop_; });
        if (stop_ || !picture.complete) return;
        done += 1.0 / std::size(kTracePasses);
        const QImage image = displayImage(picture.color, scene.exposure);
        tell(image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation), done, {});
      }
    } catch (const std::exception& caught) {
      tell({}, 0.0, QString::fromUtf8(caught.what()));
    }
  });
}

void PictureCompare::referenceDone(const QImage& image, double share, const QString& error, int run) {
  if (run != run_ || source_ != Source::Reference) return;
  if (!error.isEmpty()) {
    emit failed(error);
    return stop();
  }
  other_ = image;
  traced_ = true;
  const bool whole = share > 0.999;
  if (whole) endThread();
  name_ = whole ? tr("Ray traced") : tr("Ray traced, %1 %").arg(std::lround(100.0 * share));
  if (!difference_) showOther();  // else the picture on show is that of the last difference until the next one is made
  measured_ = false;
  rest_.start();
}

void PictureCompare::stop() {
  endThread();
  rest_.stop();
  if (source_ == Source::None) return;
  source_ = Source::None;
  difference_ = false;
  wipe_.setScaleShown(false);
  wipe_.setFlipped(false);
  wipe_.setShown(false);
  emit activeChanged(false);
}

void PictureCompare::setFlipped(bool flipped) {
  if (active()) wipe_.setFlipped(flipped);
}

void PictureCompare::setDifference(bool on) {
  if (!active() || on == difference_) return;
  difference_ = on;
  wipe_.setScaleShown(on);
  if (sameView()) showOther();
  emit differenceChanged(on);
  measured_ = false;
  rest_.start();
}

void PictureCompare::traceError() {
  if (source_ != Source::Reference) traceReference();
  if (!active()) return;
  setDifference(true);
  emit message(tr("The error against the ray-traced scene, finer as it is traced: V shows all of it, Esc ends it"));
}

// The difference waits for the picture at rest; until then the other picture stands there.
void PictureCompare::showOther() {
  wipe_.show(other_, difference_ ? tr("Difference: preparing") : name_);
}

bool PictureCompare::sameView() const {
  Camera now = hooks_.camera();
  now.name = camera_.name;
  return now == camera_;
}

void PictureCompare::pictureDrawn() {
  if (!active()) return;
  const bool same = sameView();
  wipe_.setShown(same);
  if (!same && source_ == Source::Reference) stop_ = outdated_ = true;  // the next start waits for its end
  measured_ = false;
  rest_.start();
}

// What is traced shows the scene as it was. It is begun again when the edit rests, and not waited for now.
void PictureCompare::documentChanged() {
  measured_ = false;
  if (source_ != Source::Reference) return;
  stop_ = true;
  outdated_ = true;
  rest_.start();
}

void PictureCompare::measure() {
  if (!active() || measured_) return;
  if (!hooks_.ready()) return rest_.start();
  if (!sameView()) {
    if (source_ == Source::Reference) start();
    return;
  }
  if (source_ == Source::Reference && outdated_) return start();
  if (source_ == Source::Reference && !traced_) return;  // what stands there until then is the picture itself
  const QImage now = hooks_.picture();
  if (now.size() != other_.size()) return source_ == Source::Reference ? start() : wipe_.setShown(false);
  measured_ = true;
  const double psnr = displayPsnr(now, other_);
  if (!difference_) {
    return wipe_.showNumbers(std::isinf(psnr) ? tr("No difference")
                                              : tr("Difference: PSNR %1 dB").arg(psnr, 0, 'f', 1));
  }
  const PictureDifference difference = pictureDifference(now, other_);
  wipe_.show(difference.picture, tr("Difference: %1").arg(name_));
  wipe_.showNumbers(std::isinf(psnr) ? tr("No difference")
                                     : tr("Difference: mean %1 %, 95 % of the pixels below %2 %, PSNR %3 dB")
                                           .arg(100.0 * difference.mean, 0, 'f', 1)
                                           .arg(100.0 * difference.mostOf95, 0, 'f', 1)
                                           .arg(psnr, 0, 'f', 1));
}

}  // namespace boxprobe
