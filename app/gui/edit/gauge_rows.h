// The live error of the selected probe: its mean, and for each face what leaves the box there; a face that gains by
// moving alone has a button that moves it, the worst one marked; and the way to the worst spot. Grey while the numbers
// are older than the box. Called by the fit panel.
#pragma once

#include <QTimer>
#include <QWidget>
#include <array>

#include "app/gui/edit/probe_gauge.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace boxprobe {

/// "2.31°", "14.2°".
QString degreesText(double degrees);
/// What a click on the mark of a face does, for tool tips.
QString snapHint(const BoxGauge& gauge, int face);
/// Of what is marked as the worst: its background and its text.
QString worstStyle(const QString& widget);

class GaugeRows : public QWidget {
  Q_OBJECT

 public:
  explicit GaugeRows(ProbeGauge& gauge, QWidget* parent = nullptr);

  /// There is a view from before a spot was looked at, to go back to.
  void setCanComeBack(bool can);

 signals:
  /// The camera shall look at it.
  void spotWanted(const boxprobe::WorstSpot& spot);
  void comeBackWanted();

 private:
  void refresh();
  void setGrey(bool grey);

  ProbeGauge& gauge_;
  QTimer old_;  ///< what is shown is not of the probe as it stands
  QCheckBox* live_;
  QLabel *mean_, *verdict_;
  QWidget* faces_;
  std::array<QLabel*, kFaces> errors_{};
  std::array<QToolButton*, kFaces> snaps_{};
  QPushButton *spot_, *back_;
};

}  // namespace boxprobe
