// See probe_gauge.h.
#include "app/gui/edit/probe_gauge.h"

#include "app/gui/edit/probe_fields.h"
#include "filters/fit/fit_probe.h"

namespace boxprobe {

namespace {

/// At rest the picture comes first; during a drag the number follows the hand.
constexpr int kRestMilliseconds = 150, kDragMilliseconds = 15;

/// What rays meet and who looks: all of a scene that a gauge depends on, beside the probe.
Scene surroundingsOf(const Scene& scene) {
  Scene bare;
  bare.models = scene.models;
  bare.objects = scene.objects;
  bare.materials = scene.materials;
  bare.cameras = scene.cameras;
  return bare;
}

/// Do rays followed for one do for the other?
bool sameRays(const Probe& a, const Probe& b) {
  if (a.origin != b.origin || a.hides != b.hides || a.influence.has_value() != b.influence.has_value()) return false;
  if (!a.influence) return true;
  const bool upright = a.rotationDegrees == glm::dvec3(0.0) && b.rotationDegrees == glm::dvec3(0.0);
  return *a.influence == *b.influence &&
         (upright || (a.rotationDegrees == b.rotationDegrees && a.box.center() == b.box.center()));
}

bool sameGauge(const Probe& a, const Probe& b) {
  return sameRays(a, b) && a.name == b.name && a.box == b.box && a.rotationDegrees == b.rotationDegrees;
}

}  // namespace

/// What outlives a measurement.
struct ProbeGauge::Kept {
  Scene surroundings;
  std::vector<std::shared_ptr<const Model>> models;
  std::unique_ptr<ProbeFitter> fitter;
  std::optional<Probe> followed;
  std::unique_ptr<BoxGauger> gauger;
  Counts counts;

  /// `progress` is asked whether to go on; nothing shows how far it is.
  std::optional<BoxGauge> measure(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& of,
                                  const Probe& probe, const BackgroundWork::Progress& progress) {
    if (!fitter || models != of || !(surroundings == scene)) {
      gauger.reset();
      fitter.reset();
      surroundings = scene;
      models = of;
      fitter = std::make_unique<ProbeFitter>(surroundings, models);
      ++counts.structures;
      if (!progress(0.0)) return std::nullopt;
    }
    if (!gauger || !sameRays(*followed, probe)) {
      gauger = std::make_unique<BoxGauger>(fitter->placeOf(probe), probe);
      followed = probe;
      ++counts.rays;
      if (!progress(0.0)) return std::nullopt;
    }
    ++counts.boxes;
    return gauger->measure(probe, progress);
  }
};

ProbeGauge::ProbeGauge(Editor& editor, QObject* parent)
    : QObject(parent), editor_(editor), kept_(std::make_shared<Kept>()) {
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, &ProbeGauge::start);
  connect(&work_, &BackgroundWork::ended, this, [this](bool, const QString& error) {
    counts_ = kept_->counts;
    // Models that the ray tracer cannot take have no gauge; the fit says why when it is asked for.
    if (!error.isEmpty()) forget();
    if (outdated_) return start();
    if (!error.isEmpty()) return;
    if (!measured_ || !asked_ || !sameGauge(*measured_, *asked_)) forget();
  });
}

ProbeGauge::~ProbeGauge() = default;

void ProbeGauge::setModels(const std::vector<std::shared_ptr<const Model>>& models) {
  models_ = models;
  kept_ = std::make_shared<Kept>();  // what is under way ends with what it has
  kept_->counts = counts_;
  forget();
  update();
}

void ProbeGauge::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (!on) forget();
  update();
}

void ProbeGauge::setQuiet(bool quiet) {
  if (quiet == quiet_) return;
  quiet_ = quiet;
  if (quiet) forget();
  update();
}

bool ProbeGauge::current() const {
  const Probe* probe = editor_.probe();
  return gauge_ && probe != nullptr && !outdated_ && measured_ && sameGauge(*measured_, *probe);
}

void ProbeGauge::forget() {
  if (!gauge_) return;
  gauge_.reset();
  measured_.reset();
  emit changed();
}

void ProbeGauge::update() {
  const Probe* probe = editor_.probe();
  if (!measures() || probe == nullptr || models_.empty()) {
    rest_.stop();
    work_.stop();
    return forget();
  }
  if (measured_ && measured_->name != probe->name) forget();
  outdated_ = true;
  if (gauge_) emit outdated();
  if (work_.running()) {
    // A box that moved is measured when this is done; of rays that nobody asks for any more nothing is awaited.
    if (asked_ && !sameRays(*asked_, *probe)) work_.stop();
    return;
  }
  const bool dragged = editor_.document().previewing() && asked_ && !sameGauge(*asked_, *probe);
  if (!dragged) return rest_.start(kRestMilliseconds);
  if (!rest_.isActive()) rest_.start(kDragMilliseconds);
}

void ProbeGauge::start() {
  const Probe* probe = editor_.probe();
  // Between a scene and its models, when one is opened, there is nothing to measure.
  if (!measures() || probe == nullptr || models_.size() != editor_.scene().models.size()) return;
  outdated_ = false;
  asked_ = *probe;
  work_.start([this, kept = kept_, scene = surroundingsOf(editor_.scene()), models = models_,
               probe = *probe](const BackgroundWork::Progress& progress) {
    const std::optional<BoxGauge> found = kept->measure(scene, models, probe, progress);
    BackgroundWork::Finish finish;
    if (found) {
      finish = [this, found, probe] {
        const Probe* shown = editor_.probe();
        if (!measures() || shown == nullptr || shown->name != probe.name) return;
        gauge_ = found;
        measured_ = probe;
        emit changed();
      };
    }
    return finish;
  });
}

void ProbeGauge::snap(int face) {
  if (!current()) return emit message(tr("The error is still being measured"));
  const double offset = gauge_->faces[static_cast<std::size_t>(face)].offset;
  const QString name = QString::fromStdString(editor_.probe()->name);
  editor_.commitOne(tr("Set face %1 of %2").arg(faceName(face), name),
                    [face, offset](Probe& probe) { probe = withFaceAt(probe, face, offset); });
}

}  // namespace boxprobe
