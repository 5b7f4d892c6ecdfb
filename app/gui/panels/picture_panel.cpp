// See picture_panel.h.
#include "app/gui/panels/picture_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "app/gui/edit/field_form.h"
#include "app/gui/widgets/panel_layout.h"
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

PicturePanel::PicturePanel(Editor& editor, QWidget* parent)
    : QWidget(parent),
      editor_(editor),
      slider_(new QuietSlider(Qt::Horizontal, this)),
      field_(new ValueField(fieldFormat(exposureField(), 0.1, 3), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Picture"));
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(slider_, 1);
  row->addWidget(field_);
  const QString tip = tr("%1 The slider spans %2 stops either way.").arg(fieldTip(exposureField())).arg(kStops);
  slider_->setRange(-kStops * kSliderPerStop, kStops * kSliderPerStop);
  slider_->setToolTip(tip);
  field_->setToolTip(tip);
  addRow(form, tr("Exposure"), line, tip);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    const double exposure = std::exp2(static_cast<double>(value) / kSliderPerStop);
    slider_->isSliderDown() ? preview(exposure) : commit(exposure);
  });
  connect(slider_, &QSlider::sliderReleased, this, [this] { editor_.finish(); });
  connect(field_, &ValueField::previewed, this, &PicturePanel::preview);
  connect(field_, &ValueField::committed, this, &PicturePanel::commit);
  update();
}

void PicturePanel::preview(double exposure) {
  editor_.preview({this}, tr("Set exposure"), exposureEdit(exposure));
}

void PicturePanel::commit(double exposure) {
  editor_.commit({this}, tr("Set exposure"), exposureEdit(exposure));
}

void PicturePanel::update() {
  const double exposure = editor_.scene().exposure;
  field_->show(exposure);
  const QSignalBlocker quiet(slider_);
  if (!slider_->isSliderDown()) {
    slider_->setValue(static_cast<int>(
        std::lround(std::log2(std::max(exposure, formRange(exposureField()).lowest)) * kSliderPerStop)));
  }
}

}  // namespace boxprobe
