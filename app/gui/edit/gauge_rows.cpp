// See gauge_rows.h.
#include "app/gui/edit/gauge_rows.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

namespace boxprobe {

namespace {

/// A number that is soon followed by the next does not flicker.
constexpr int kOldMilliseconds = 400;

}  // namespace

QString degreesText(double degrees) {
  return QString::number(degrees, 'f', degrees < 10.0 ? 2 : 1) + QString::fromUtf8("\u00b0");
}

QString snapHint(const BoxGauge& gauge, int face) {
  return GaugeRows::tr("Moves face %1 alone to where the box is least wrong: the mean error falls by %2")
      .arg(faceName(face), degreesText(gauge.faces[static_cast<std::size_t>(face)].gainDegrees));
}

QString worstStyle(const QString& widget) {
  return widget + " { color: #1a1206; background: #f0a030; border-radius: 4px; padding: 1px 5px; font-weight: bold; }";
}

GaugeRows::GaugeRows(ProbeGauge& gauge, QWidget* parent)
    : QWidget(parent),
      gauge_(gauge),
      live_(new QCheckBox(tr("Live error"), this)),
      mean_(new QLabel(this)),
      verdict_(new QLabel(this)),
      faces_(new QWidget(this)),
      spot_(new QPushButton(this)),
      back_(new QPushButton(tr("Back"), this)) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  live_->setObjectName("liveError");
  live_->setChecked(gauge.on());
  live_->setToolTip(tr("Angle between what reflected rays look up and what they should, while the box is edited"));
  mean_->setObjectName("gaugeMean");
  mean_->setWordWrap(true);
  verdict_->setObjectName("gaugeVerdict");
  verdict_->setWordWrap(true);
  rows->addWidget(live_);
  rows->addWidget(mean_);
  rows->addWidget(verdict_);
  rows->addWidget(faces_);
  auto* grid = new QGridLayout(faces_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  for (int face = 0; face < kFaces; ++face) {
    const auto index = static_cast<std::size_t>(face);
    errors_[index] = new QLabel(faces_);
    errors_[index]->setObjectName(QString("gaugeFace%1").arg(face));
    snaps_[index] = new QToolButton(faces_);
    snaps_[index]->setObjectName(QString("gaugeSnap%1").arg(face));
    QSizePolicy kept = snaps_[index]->sizePolicy();
    kept.setRetainSizeWhenHidden(true);  // rows stay where they are while the pointer is over them
    snaps_[index]->setSizePolicy(kept);
    const int column = 3 * (face % 2);
    grid->addWidget(errors_[index], face / 2, column);
    grid->addWidget(snaps_[index], face / 2, column + 1);
    connect(snaps_[index], &QToolButton::clicked, this, [this, face] { gauge_.snap(face); });
  }
  grid->setColumnStretch(2, 1);
  grid->setColumnStretch(5, 1);
  auto* buttons = new QHBoxLayout;
  spot_->setObjectName("worstSpot");
  back_->setObjectName("worstSpotBack");
  back_->setToolTip(tr("The view from before"));
  buttons->addWidget(spot_, 1);
  buttons->addWidget(back_);
  rows->addLayout(buttons);
  connect(live_, &QCheckBox::toggled, &gauge_, &ProbeGauge::setOn);
  connect(&gauge_, &ProbeGauge::changed, this, &GaugeRows::refresh);
  old_.setSingleShot(true);
  old_.setInterval(kOldMilliseconds);
  connect(&gauge_, &ProbeGauge::outdated, this, [this] {
    if (!old_.isActive()) old_.start();
  });
  connect(&old_, &QTimer::timeout, this, [this] { setGrey(!gauge_.current()); });
  connect(spot_, &QPushButton::clicked, this, [this] {
    if (gauge_.gauge() && gauge_.gauge()->spot) emit spotWanted(*gauge_.gauge()->spot);
  });
  connect(back_, &QPushButton::clicked, this, &GaugeRows::comeBackWanted);
  setCanComeBack(false);
  refresh();
}

void GaugeRows::setCanComeBack(bool can) {
  back_->setEnabled(can);
}

void GaugeRows::setGrey(bool grey) {
  for (QLabel* label : {mean_, verdict_}) label->setEnabled(!grey);
  for (QLabel* label : errors_) label->setEnabled(!grey);
}

void GaugeRows::refresh() {
  const std::optional<BoxGauge>& gauge = gauge_.gauge();
  old_.stop();
  if (gauge && !gauge_.current()) old_.start();
  setGrey(false);
  mean_->setVisible(gauge.has_value());
  verdict_->setVisible(gauge.has_value());
  faces_->setVisible(gauge.has_value());
  spot_->setEnabled(gauge && gauge->spot);
  spot_->setText(gauge && gauge->spot ? tr("Look at the worst spot (%1)").arg(degreesText(gauge->spot->degrees))
                                      : tr("Look at the worst spot"));
  spot_->setToolTip(
      tr("Moves the camera to where reflections are most wrong. The error there is at least every face's mean."));
  if (!gauge) return;
  mean_->setText(tr("Mean error %1, 95 % below %2")
                     .arg(degreesText(gauge->errors.meanDegrees), degreesText(gauge->errors.p95Degrees)));
  const QString counted = degreesText(countedGain(gauge->errors.meanDegrees));
  verdict_->setText(gauge->worst
                        ? tr("Face %1 alone can take %2 off the mean: click its button")
                              .arg(faceName(*gauge->worst),
                                   degreesText(gauge->faces[static_cast<std::size_t>(*gauge->worst)].gainDegrees))
                        : tr("No face alone can take %1 off the mean").arg(counted));
  for (int face = 0; face < kFaces; ++face) {
    const auto index = static_cast<std::size_t>(face);
    const FaceGauge& each = gauge->faces[index];
    const bool worst = gauge->worst == face;
    errors_[index]->setText(QString("%1  %2").arg(
        faceName(face), each.share > 0.0 ? degreesText(each.meanDegrees) : QString::fromUtf8("\u2013")));
    errors_[index]->setToolTip(tr("Mean error of what leaves the box through this face: %1 % of the reflections")
                                   .arg(100.0 * each.share, 0, 'f', each.share < 0.1 ? 1 : 0));
    QToolButton* snap = snaps_[index];
    snap->setVisible(each.gainDegrees >= countedGain(gauge->errors.meanDegrees));
    // A sign that stays before its number in a window from right to left.
    const QString sign = QString::fromUtf8(isRightToLeft() ? "\u200e\u2212" : "\u2212");
    snap->setText(sign + degreesText(each.gainDegrees));
    snap->setToolTip(snapHint(*gauge, face));
    snap->setProperty("worst", worst);
    snap->setStyleSheet(worst ? worstStyle("QToolButton") : QString());
  }
}

}  // namespace boxprobe
