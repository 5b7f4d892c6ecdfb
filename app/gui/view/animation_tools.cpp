// See animation_tools.h.
#include "app/gui/view/animation_tools.h"

#include <QLabel>
#include <QMainWindow>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/quiet_slider.h"
#include "filters/core/base/scope_exit.h"
#include "filters/vtk/import/model_reader.h"

namespace boxprobe {

namespace {

constexpr int kSteps = 1000;

}  // namespace

AnimationTools::AnimationTools(Workspace& workspace, QMainWindow* window)
    : QObject(window),
      workspace_(workspace),
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
  connect(slider_, &QSlider::sliderReleased, this, [this] { workspace_.editor().finish(); });
  connect(rest_, &QToolButton::clicked, this,
          [this](bool rest) { ask(rest ? Time() : Time(length() * slider_->value() / kSteps), true); });
  connect(&work_, &BackgroundWork::ended, this, [this](bool, const QString& error) {
    if (!error.isEmpty() && index_ && reading_.model == shown_.model) {
      failed_ = reading_;
      emit failed(error);
    }
    reading_ = {};
    read();
  });
  connect(&workspace, &Workspace::opened, this, &AnimationTools::opened);
  connect(&workspace, &Workspace::modelsReplaced, this, &AnimationTools::forget);
  connect(&workspace, &Workspace::lessonShown, this, [this](bool open) { open ? forget() : opened(); });
  connect(this, &AnimationTools::failed, &workspace, &Workspace::failed);
  workspace.changes().add("animation", {&Changes::models}, [this](const Changes&) { modelsChanged(); });
  // A layout that is restored knows nothing of the model; with the tools hidden the picture stands alone.
  for (QToolBar* bar : {bar_, window->findChild<QToolBar*>("tools")}) {
    if (bar != nullptr) connect(bar, &QToolBar::visibilityChanged, this, &AnimationTools::update, Qt::QueuedConnection);
  }
}

void AnimationTools::opened() {
  const Models& models = workspace_.models();
  const std::size_t count = std::min(models.size(), workspace_.document().scene().models.size());
  index_.reset();
  for (std::size_t i = 0; i < count && !index_; ++i) {
    if (models[i] && models[i]->animationSeconds > 0.0) index_ = i;
  }
  // A lesson that stood in its place gives the same model back, read when it was.
  if (!index_) shown_ = {};
  if (index_ && models[*index_] != shown_.model) shown_ = {models[*index_], wanted()};
  failed_ = {};
  update();
  read();
}

void AnimationTools::forget() {
  if (taking_) return;
  index_.reset();
  update();
}

void AnimationTools::modelsChanged() {
  if (!index_) return;
  if (*index_ >= workspace_.document().scene().models.size()) return forget();
  update();
  read();
}

AnimationTools::Time AnimationTools::wanted() const {
  const auto& files = workspace_.document().scene().models;
  return index_ && *index_ < files.size() ? files[*index_].time : Time();
}

double AnimationTools::length() const {
  return index_ && shown_.model ? shown_.model->animationSeconds : 0.0;
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
  last ? workspace_.editor().commit(token, tr("Animation time"), edit)
       : workspace_.editor().preview(token, tr("Animation time"), edit);
}

void AnimationTools::read() {
  if (!index_ || *index_ >= workspace_.models().size() || work_.running() || wanted() == shown_.time) return;
  const Pose before = shown_;
  if (failed_.model == before.model && failed_.time == wanted()) return;
  const ModelFile file = workspace_.document().scene().models[*index_];
  reading_ = {before.model, file.time};
  work_.start([this, file, before](const BackgroundWork::Progress& progress) -> BackgroundWork::Finish {
    const Pose pose{std::make_shared<const Model>(readModel(file.file, progress, {file.variant, file.time})),
                    file.time};
    return [this, pose, before] { take(pose, before); };
  });
}

void AnimationTools::take(const Pose& pose, const Pose& before) {
  Models models = workspace_.models();
  // Another scene was opened meanwhile, or a lesson stands there.
  if (!index_ || *index_ >= models.size() || models[*index_] != before.model) return;
  if (workspace_.handles().dragging()) {
    constexpr int kAgain = 100;  // milliseconds
    QTimer::singleShot(kAgain, this, [this, pose, before] { take(pose, before); });
    return;
  }
  models[*index_] = pose.model;
  taking_ = true;
  const ScopeExit taken([this] { taking_ = false; });
  shown_ = pose;
  failed_ = {};
  workspace_.takePose(models);
  workspace_.changes().updateAll();
  update();
}

void AnimationTools::update() {
  const auto* tools = bar_->parentWidget()->findChild<QToolBar*>("tools");
  const bool wantedHere = index_ && (tools == nullptr || !tools->isHidden());
  if (bar_->isHidden() == wantedHere) bar_->setVisible(wantedHere);
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
