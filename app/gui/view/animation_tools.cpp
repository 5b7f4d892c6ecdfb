// See animation_tools.h.
#include "app/gui/view/animation_tools.h"

#include <QLabel>
#include <QMainWindow>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/gui/edit/editor.h"
#include "app/gui/widgets/quiet_slider.h"
#include "filters/vtk/import/model_reader.h"

namespace boxprobe {

namespace {

constexpr int kSteps = 1000;

}  // namespace

AnimationTools::AnimationTools(Parts parts, QMainWindow* window)
    : QObject(window),
      parts_(std::move(parts)),
      bar_(new QToolBar(tr("Animation"), window)),
      slider_(new QuietSlider(Qt::Horizontal, bar_)),
      text_(new QLabel(bar_)),
      rest_(new QToolButton(bar_)),
      work_(this) {
  bar_->setObjectName("animation");
  bar_->setMovable(false);
  bar_->setContextMenuPolicy(Qt::PreventContextMenu);
  auto* name = new QLabel(tr("Animation"), bar_);
  name->setContentsMargins(6, 0, 6, 0);
  slider_->setObjectName("animationTime");
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 20);
  slider_->setToolTip(tr("Time at which the model's animations are shown"));
  slider_->setAccessibleName(tr("Animation time"));
  text_->setObjectName("animationText");
  text_->setMinimumWidth(text_->fontMetrics().horizontalAdvance("000.00 s / 000.00 s"));
  text_->setContentsMargins(6, 0, 6, 0);
  rest_->setObjectName("animationRest");
  rest_->setText(tr("At rest"));
  rest_->setToolTip(tr("Shows the model as it stands without its animations"));
  rest_->setCheckable(true);
  bar_->addWidget(name);
  bar_->addWidget(slider_);
  bar_->addWidget(text_);
  bar_->addWidget(rest_);
  window->addToolBarBreak();
  window->addToolBar(bar_);
  bar_->hide();
  bar_->toggleViewAction()->setVisible(false);
  connect(slider_, &QSlider::valueChanged, this, &AnimationTools::drag);
  connect(slider_, &QSlider::sliderReleased, this, [this] { drag(slider_->value()); });
  connect(rest_, &QToolButton::clicked, this,
          [this](bool rest) { ask(rest ? Time() : Time(length() * slider_->value() / kSteps), true); });
  connect(&work_, &BackgroundWork::ended, this, [this](bool, const QString& error) {
    if (!error.isEmpty()) {
      hasFailed_ = true;
      failed_ = wanted();
      emit failed(error);
    }
    read();
  });
}

void AnimationTools::opened() {
  const Models& models = parts_.models();
  const std::size_t count = std::min(models.size(), parts_.document.scene().models.size());
  index_.reset();
  hasFailed_ = false;
  for (std::size_t i = 0; i < count && !index_; ++i) {
    if (models[i] && models[i]->animationSeconds > 0.0) index_ = i;
  }
  shown_ = wanted();
  update();
}

void AnimationTools::forget() {
  if (taking_) return;
  index_.reset();
  update();
}

void AnimationTools::setBorrowed(bool borrowed) {
  borrowed ? forget() : opened();
}

void AnimationTools::modelsChanged() {
  if (!index_) return;
  if (*index_ >= parts_.document.scene().models.size()) return forget();
  update();
  read();
}

AnimationTools::Time AnimationTools::wanted() const {
  return index_ ? parts_.document.scene().models[*index_].time : Time();
}

double AnimationTools::length() const {
  return index_ ? parts_.models()[*index_]->animationSeconds : 0.0;
}

void AnimationTools::drag(int position) {
  // Hundredths of a second where they are finer than the slider's steps.
  const double time = length() * position / kSteps;
  ask(length() > 10.0 ? std::round(100.0 * time) / 100.0 : time, !slider_->isSliderDown());
}

// A whole drag is one step, and what a preview has is read as soon as what was asked for before is on show.
void AnimationTools::ask(const Time& time, bool last) {
  if (!index_) return;
  const auto edit = [index = *index_, time](Scene& scene) {
    if (index < scene.models.size()) scene.models[index].time = time;
  };
  const EditToken token{this, 0, {}};
  last ? parts_.editor.commit(token, tr("Animation time"), edit)
       : parts_.editor.preview(token, tr("Animation time"), edit);
}

void AnimationTools::read() {
  if (!index_ || work_.running() || wanted() == shown_ || (hasFailed_ && wanted() == failed_)) return;
  const std::size_t index = *index_;
  const ModelFile file = parts_.document.scene().models[index];
  const std::shared_ptr<const Model> before = parts_.models()[index];
  work_.start([this, file, index, before](const BackgroundWork::Progress& progress) -> BackgroundWork::Finish {
    auto model = std::make_shared<const Model>(readModel(file.file, progress, {file.variant, file.time}));
    return [this, model, file, index, before] {
      Models models = parts_.models();
      // Another scene was opened meanwhile.
      if (index_ != index || models[index] != before) return;
      models[index] = model;
      shown_ = file.time;
      taking_ = true;
      parts_.show(models);
      taking_ = false;
      update();
    };
  });
}

void AnimationTools::update() {
  bar_->setVisible(index_.has_value());
  if (!index_) return;
  const Time time = wanted();
  const QSignalBlocker slider(slider_), rest(rest_);
  const double share = length() > 0.0 ? time.value_or(0.0) / length() : 0.0;
  if (!slider_->isSliderDown()) slider_->setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kSteps)));
  rest_->setChecked(!time);
  text_->setText(time ? tr("%1 s / %2 s").arg(*time, 0, 'f', 2).arg(length(), 0, 'f', 2)
                      : tr("at rest / %1 s").arg(length(), 0, 'f', 2));
}

}  // namespace boxprobe
