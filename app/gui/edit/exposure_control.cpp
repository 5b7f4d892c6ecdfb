// See exposure_control.h.
#include "app/gui/edit/exposure_control.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "app/gui/edit/field_form.h"
#include "app/gui/widgets/quiet_slider.h"
#include "app/gui/widgets/value_field.h"

namespace boxprobe {

namespace {

constexpr int kSliderPerStop = 10;
constexpr int kStops = 6;  ///< either way

const FieldRow<Scene>& exposureField() {
  return fieldNamed(sceneFields(), "exposure");
}

Document::Edit exposureEdit(double exposure) {
  return [exposure](Scene& scene) { scene.exposure = exposure; };
}

}  // namespace

QString ExposureControl::toolTipText() {
  return tr("%1 The slider spans %2 stops either way. Keys: [ darker, ] brighter.")
      .arg(fieldTip(exposureField()))
      .arg(kStops);
}

ExposureControl::ExposureControl(Editor& editor, QWidget* parent)
    : QWidget(parent),
      editor_(editor),
      slider_(new QuietSlider(Qt::Horizontal, this)),
      field_(new ValueField(fieldFormat(exposureField(), 0.1, 3), this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(slider_, 1);
  row->addWidget(field_);
  slider_->setRange(-kStops * kSliderPerStop, kStops * kSliderPerStop);
  slider_->setToolTip(toolTipText());
  field_->setToolTip(toolTipText());
  rest_.setSingleShot(true);
  rest_.setInterval(ValueField::kRestMilliseconds);
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (editor_.previews({this})) editor_.finish();
  });
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    const double exposure = std::exp2(static_cast<double>(value) / kSliderPerStop);
    slider_->isSliderDown() ? preview(exposure) : commit(exposure);
  });
  connect(slider_, &QSlider::sliderReleased, this, [this] { editor_.finish(); });
  connect(field_, &ValueField::previewed, this, &ExposureControl::preview);
  connect(field_, &ValueField::committed, this, &ExposureControl::commit);
  update();
}

void ExposureControl::preview(double exposure) {
  rest_.stop();
  editor_.preview({this}, tr("Set exposure"), exposureEdit(exposure));
}

void ExposureControl::commit(double exposure) {
  rest_.stop();
  editor_.commit({this}, tr("Set exposure"), exposureEdit(exposure));
}

// Three digits are enough to read, and so is what the scene file says.
void ExposureControl::step(double stops) {
  const FieldRange range = formRange(exposureField());
  const double exact = std::max(editor_.scene().exposure, range.lowest) * std::exp2(stops);
  const double unit = std::pow(10.0, std::floor(std::log10(exact)) - 2.0);
  preview(std::clamp(std::round(exact / unit) * unit, range.lowest, range.highest));
  rest_.start();
}

void ExposureControl::update() {
  const double exposure = editor_.scene().exposure;
  field_->show(exposure);
  const QSignalBlocker quiet(slider_);
  if (!slider_->isSliderDown()) {
    slider_->setValue(static_cast<int>(
        std::lround(std::log2(std::max(exposure, formRange(exposureField()).lowest)) * kSliderPerStop)));
  }
}

}  // namespace boxprobe
