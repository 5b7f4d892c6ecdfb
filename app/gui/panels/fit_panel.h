// Fits the selected probe's box to what it sees, in a thread of its own, and lets its user review the result before it
// counts: both errors, the gain of each face, the fitted box drawn beside the old one. Above it the live error of the
// box as it stands, which is written beside the handles, too.
#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/edit/background_work.h"
#include "app/gui/edit/editor.h"
#include "app/session/fit_light_errors.h"
#include "filters/core/scene/model.h"
#include "filters/fit/box/fit_box.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QWidget;

namespace boxprobe {

class GaugeRows;
class ProbeGauge;
class Workspace;

class FitPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FitPanel(Workspace& workspace);

  /// The error of the probe as it stands.
  ProbeGauge& gauge() { return *gauge_; }

  /// Starts a fit of the selected probe, or stops the one under way.
  void fit();
  bool running() const { return work_.running(); }
  /// As one undo step, with the faces that are ticked.
  void apply();
  void discard();

 signals:
  /// The box that apply() would set; nothing: none is under review.
  void ghostChanged(const std::optional<boxprobe::Probe>& ghost);
  void message(const QString& text);
  void failed(const QString& line);

 private:
  void observe(Workspace& workspace);
  /// The document changed: a result for what is no longer so is dropped.
  void update();
  void review(const BoxFit& result, const std::optional<FitLightErrors>& light);
  Probe proposed() const;
  void refresh();

  Editor& editor_;
  ProbeGauge* gauge_;
  GaugeRows* rows_;
  std::vector<std::shared_ptr<const Model>> models_;
  QPushButton *fit_, *apply_, *discard_;
  QLabel *errors_, *remarks_;
  QWidget* review_;
  std::array<QCheckBox*, kFaces> faces_{};
  std::optional<Probe> given_;  ///< what is fitted, or was
  std::optional<BoxFit> result_;
  std::optional<FitLightErrors> light_;  ///< of `result_`; empty without light
  BackgroundWork work_;                  ///< last: it ends before what it would tell of it
};

}  // namespace boxprobe
