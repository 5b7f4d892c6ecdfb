// See fit_panel.h.
#include "app/gui/panels/fit_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>
#include <cmath>

#include "app/gui/edit/gauge_rows.h"
#include "app/gui/edit/probe_fields.h"
#include "app/gui/handles/face_tags.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/phrase_words.h"
#include "filters/fit/fit_probe.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

namespace {

/// With its sign: "-5.8 %".
QString percentText(double share) {
  return QString::fromUtf8(share < 0.0 ? "\u2212" : "+") + QString::number(100.0 * std::abs(share), 'f', 1) + " %";
}

QString errorsText(const BoxFit& fit, const std::optional<FitLightErrors>& light) {
  const QString arrow = QString::fromUtf8(" \u2192 ");
  QString text = FitPanel::tr("Mean error %1, 95 %: %2")
                     .arg(degreesText(fit.before.meanDegrees) + arrow + degreesText(fit.after.meanDegrees),
                          degreesText(fit.before.p95Degrees) + arrow + degreesText(fit.after.p95Degrees));
  if (light) {
    text +=
        FitPanel::tr("; light error %1%2%3 %")
            .arg(QString::number(100.0 * light->before, 'f', 1), arrow, QString::number(100.0 * light->after, 'f', 1));
  }
  return text;
}

}  // namespace

FitPanel::FitPanel(Workspace& workspace)
    : editor_(workspace.editor()),
      gauge_(new ProbeGauge(workspace.editor(), this)),
      rows_(new GaugeRows(*gauge_, this)),
      fit_(new QPushButton(this)),
      apply_(new QPushButton(tr("Apply"), this)),
      discard_(new QPushButton(tr("Discard"), this)),
      errors_(new QLabel(this)),
      remarks_(helpLabel(this)),
      review_(new QWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Fit"));
  fit_->setObjectName("fitBox");
  fit_->setToolTip(tr("Fits the box of the selected probe to the walls that its origin sees (Ctrl+F)"));
  form->addRow(rows_);
  form->addRow(fit_);
  form->addRow(remarks_);
  form->addRow(review_);

  auto* rows = new QVBoxLayout(review_);
  rows->setContentsMargins(0, 0, 0, 0);
  errors_->setObjectName("fitErrors");
  errors_->setWordWrap(true);
  errors_->setToolTip(
      tr("Before and after: the angle between the sampled and the true direction, and the error of the sampled light"));
  rows->addWidget(errors_);
  for (int face = 0; face < kFaces; ++face) {
    auto* box = new QCheckBox(faceName(face), review_);
    box->setObjectName(QString("fitFace%1").arg(face));
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // the column is no wider for it
    faces_[static_cast<std::size_t>(face)] = box;
    rows->addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this] {
      if (result_) emit ghostChanged(proposed());
    });
  }
  auto* buttons = new QHBoxLayout;
  apply_->setObjectName("applyFit");
  discard_->setObjectName("discardFit");
  buttons->addWidget(apply_);
  buttons->addWidget(discard_);
  rows->addLayout(buttons);
  connect(fit_, &QPushButton::clicked, this, &FitPanel::fit);
  connect(apply_, &QPushButton::clicked, this, &FitPanel::apply);
  connect(discard_, &QPushButton::clicked, this, &FitPanel::discard);
  connect(gauge_, &ProbeGauge::message, this, &FitPanel::message);
  connect(&work_, &BackgroundWork::progressed, this, &FitPanel::refresh);
  connect(&work_, &BackgroundWork::ended, this, [this](bool stopped, const QString& error) {
    if (!error.isEmpty()) emit failed(error);
    if (stopped) emit message(tr("The fit was stopped"));
    refresh();
  });
  observe(workspace);
  refresh();
}

void FitPanel::observe(Workspace& workspace) {
  workspace.listenTo(this);
  connect(workspace.actions().fit, &QAction::triggered, this, &FitPanel::fit);
  connect(&workspace, &Workspace::modelsReplaced, this, [this, &workspace] {
    models_ = workspace.models();
    gauge_->setModels(models_);
  });
  // A lesson's room is wrong on purpose, and the lesson says how.
  connect(&workspace, &Workspace::lessonShown, this, [this, &workspace] {
    gauge_->setQuiet(workspace.lesson() != nullptr);
    rows_->setVisible(workspace.lesson() == nullptr);
  });
  using C = Changes;
  workspace.changes().add("fit panel", selectedProbeKinds(), [this](const C&) { update(); });
  workspace.changes().add("live error",
                          {&C::probeShape, &C::probeCapture, &C::probeList, &C::selection, &C::materials, &C::objects,
                           &C::models, &C::cameras},
                          [this](const C&) { gauge_->update(); });

  auto* tags = new FaceTags(*gauge_, editor_,
                            {[&workspace] { return workspace.viewport().view(); },
                             [&workspace] {
                               return workspace.shownHandles().GetVisibility() != 0 &&
                                      workspace.handles().mode() == HandleMode::Box;
                             }},
                            &workspace.viewport());
  connect(&workspace.scheduler(), &RenderScheduler::rendered, tags, &FaceTags::follow);
  connect(&workspace, &Workspace::posesChanged, tags, [tags] { tags->showSpot({}); });
  connect(rows_, &GaugeRows::spotWanted, tags, [&workspace, tags](const WorstSpot& spot) {
    workspace.views().lookAtSpot(spot.positionWorld, spot.eyeWorld);
    tags->showSpot(spot);
  });
  connect(rows_, &GaugeRows::comeBackWanted, tags, [&workspace, tags] {
    workspace.views().comeBack();
    tags->showSpot({});
  });
  connect(&workspace.views(), &ViewCommands::canComeBack, rows_, &GaugeRows::setCanComeBack);
}

void FitPanel::fit() {
  if (running()) {
    work_.stop();
    return;
  }
  const Probe* probe = editor_.probe();
  if (probe == nullptr || models_.empty()) return;
  discard();
  given_ = *probe;
  work_.start(
      [this, scene = editor_.scene(), models = models_, probe = *probe](const BackgroundWork::Progress& progress) {
        ProbeFitter fitter(scene, models);
        const std::optional<BoxFit> fitted = fitter.fit(probe, {}, [&](double done) { return progress(0.5 * done); });
        BackgroundWork::Finish finish;
        if (!fitted) return finish;
        std::optional<FitLightErrors> light;
        if (fitted->outcome == FitOutcome::Fitted) {
          bool stopped = false;
          light = fitLightErrors(scene, models, fitter, probe, *fitted, [&](double done) {
            stopped = stopped || !progress(0.5 + 0.5 * done);
            return !stopped;
          });
          if (stopped) return finish;
        }
        finish = [this, result = *fitted, light] { review(result, light); };
        return finish;
      });
  refresh();
}

void FitPanel::review(const BoxFit& result, const std::optional<FitLightErrors>& light) {
  const Probe* probe = editor_.probe();
  if (probe == nullptr || !(*probe == *given_)) {
    emit message(tr("The probe changed meanwhile: fit it again"));
    return;
  }
  result_ = result;
  light_ = light;
  for (int face = 0; face < kFaces; ++face) {
    const FaceFit& fitted = result_->faces[static_cast<std::size_t>(face)];
    QCheckBox* box = faces_[static_cast<std::size_t>(face)];
    const QSignalBlocker quiet(box);
    box->setChecked(true);
    box->setText(QString("%1: ").arg(faceName(face)) +
                 (fitted.free ? tr("hardly matters") : tr("gains %1").arg(degreesText(fitted.gainDegrees))) +
                 (light_ ? tr(", light error %1").arg(percentText(-light_->faceGain[static_cast<std::size_t>(face)]))
                         : QString()));
    box->setToolTip(tr(
        "What this face alone changes: the mean angle, and the error of the sampled light (negative is better). Leave "
        "out a face that improves the angle but worsens the light."));
  }
  QStringList lines;
  for (const Phrase& remark : result_->remarks) lines += phraseWords(remark);
  remarks_->setText(lines.join(". "));
  if (result_->outcome == FitOutcome::Fitted) emit ghostChanged(proposed());
}

Probe FitPanel::proposed() const {
  OffsetBox mixed = offsetBox(result_->probe);
  // A face that is not accepted stays as far from the origin as it was.
  const OffsetBox before = offsetBox(*given_);
  bool all = true;
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    if (faces_[face]->isChecked()) continue;
    mixed.offset[face] = before.offset[face];
    all = false;
  }
  return all ? result_->probe : withOffsetBox(*given_, mixed, result_->probe.rotationDegrees);
}

void FitPanel::apply() {
  if (!result_ || result_->outcome != FitOutcome::Fitted) return;
  const Probe fitted = proposed();
  const QString label = tr("Set fit of %1").arg(QString::fromStdString(fitted.name));
  discard();
  editor_.commitOne(label, [fitted](Probe& probe) { probe = fitted; });
}

void FitPanel::discard() {
  result_.reset();
  remarks_->clear();
  emit ghostChanged({});
  refresh();
}

void FitPanel::update() {
  const Probe* probe = editor_.probe();
  if (result_ && (probe == nullptr || !(*probe == *given_))) discard();
  refresh();
}

void FitPanel::refresh() {
  fit_->setText(running() ? tr("Stop (%1 %)").arg(work_.percent()) : tr("Fit box"));
  fit_->setEnabled(running() || (editor_.probe() != nullptr && !models_.empty()));
  const bool fitted = result_ && result_->outcome == FitOutcome::Fitted;
  review_->setVisible(fitted);
  remarks_->setVisible(result_ && (!fitted || !remarks_->text().isEmpty()));
  if (!result_) return;
  if (fitted) {
    errors_->setText(errorsText(*result_, light_));
    return;
  }
  if (result_->outcome == FitOutcome::Kept) {
    remarks_->setText(tr("The box fits already: mean error %1").arg(degreesText(result_->before.meanDegrees)));
  } else if (remarks_->text().isEmpty()) {
    remarks_->setText(result_->outcome == FitOutcome::Open ? tr("Open: nothing to fit to; the box stays")
                                                           : tr("The origin is inside of a wall: move it first"));
  }
}

}  // namespace boxprobe
