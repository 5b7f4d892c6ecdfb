// See picture_compare.h.
#include "app/gui/view/picture_compare.h"

#include <cmath>
#include <utility>

#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/picture_difference.h"

namespace boxprobe {

namespace {

constexpr int kRestMilliseconds = 300;

}  // namespace

PictureCompare::PictureCompare(const Document& document, CompareWipe& wipe, Hooks hooks, QObject* parent)
    : QObject(parent), document_(document), wipe_(wipe), hooks_(std::move(hooks)) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMilliseconds);
  connect(&rest_, &QTimer::timeout, this, &PictureCompare::measure);
  connect(&trace_, &ReferenceTrace::traced, this, &PictureCompare::referenceDone);
  connect(&trace_, &ReferenceTrace::failed, this, [this](const QString& line) {
    emit failed(line);
    stop();
  });
}

void PictureCompare::hold() {
  trace_.end();
  other_ = hooks_.picture();
  if (other_.isNull()) return;
  otherLight_ = nullptr;
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

QString PictureCompare::referenceName() const {
  return light_ == TracedLight::All ? tr("Path traced") : tr("Reflection traced");
}

void PictureCompare::traceReference(TracedLight light) {
  source_ = Source::Reference;
  light_ = light;
  start();
  if (!active()) return;
  emit activeChanged(true);
  emit message(light == TracedLight::All
                   ? tr("All light, path traced in the background, with as many bounces as the probes have. V flips, "
                        "Esc ends it")
                   : tr("The picture with its reflection ray traced: all other light is the picture's own. Mirrors in "
                        "mirrors stay black. V flips, Esc ends it"));
}

void PictureCompare::start() {
  trace_.end();
  const QImage now = hooks_.picture();
  if (now.isNull()) return stop();
  camera_ = hooks_.camera();
  size_ = now.size();
  measured_ = outdated_ = traced_ = false;
  otherLight_ = nullptr;
  other_ = now;
  name_ = tr("%1: preparing").arg(referenceName());
  showOther();
  wipe_.showNumbers({});
  trace_.start(document_.scene(), hooks_.models(), camera_, size_, light_,
               light_ == TracedLight::Reflection ? hooks_.diffuse() : ProbesDiffuse());
}

void PictureCompare::referenceDone(const QImage& image, double share,
                                   const std::shared_ptr<const ReferencePicture>& light) {
  if (source_ != Source::Reference) return;
  otherLight_ = light;
  other_ = image;
  traced_ = true;
  name_ = share >= 1.0 ? referenceName() : tr("%1, %2 %").arg(referenceName()).arg(std::lround(100.0 * share));
  if (!difference_) showOther();  // else the picture on show is that of the last difference until the next one is made
  measured_ = false;
  rest_.start();
}

void PictureCompare::stop() {
  trace_.end();
  rest_.stop();
  if (source_ == Source::None) return;
  source_ = Source::None;
  otherLight_ = nullptr;
  difference_ = false;
  wipe_.setScaleShown(false);
  wipe_.setFlipped(false);
  wipe_.setShown(false);
  emit message({});
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
  if (source_ != Source::Reference || light_ != TracedLight::All) traceReference(TracedLight::All);
  if (!active()) return;
  setDifference(true);
  emit message(tr("The error against all light gets finer as more paths are traced; V shows all of it, Esc ends it"));
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
  if (!same && source_ == Source::Reference) {
    trace_.requestStop();
    outdated_ = true;
  }
  measured_ = false;
  rest_.start();
}

// What is traced shows the scene as it was. It is begun again when the edit rests, and not waited for now.
void PictureCompare::documentChanged() {
  measured_ = false;
  if (source_ != Source::Reference) return;
  trace_.requestStop();
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
                                              : tr("Difference: PSNR %1 dB").arg(psnr, 0, 'f', 1) + lightNumbers());
  }
  const PictureDifference difference = pictureDifference(now, other_);
  wipe_.show(difference.picture, tr("Difference: %1").arg(name_));
  wipe_.showNumbers(std::isinf(psnr) ? tr("No difference")
                                     : tr("Difference: mean %1 %, 95 % of the pixels below %2 %, PSNR %3 dB")
                                               .arg(100.0 * difference.mean, 0, 'f', 1)
                                               .arg(100.0 * difference.mostOf95, 0, 'f', 1)
                                               .arg(psnr, 0, 'f', 1) +
                                           lightNumbers());
}

// Nothing while the traced picture is coarse.
QString PictureCompare::lightNumbers() const {
  if (!otherLight_) return {};
  const auto off = lightDifference(hooks_.light(size_), *otherLight_);
  return off ? tr(". Against the traced: %1").arg(lightText(*off)) : QString();
}

}  // namespace boxprobe
