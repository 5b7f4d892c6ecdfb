// What the surfaces are coloured by: one entry a row of surfaceViews(), its range, and what it means. The table decides
// what is here. Called by the debug view; knows no renderer.
#pragma once

#include <QWidget>
#include <utility>

#include "filters/core/scene/surface_view.h"
#include "filters/explain/explanation.h"

class QCheckBox;
class QLabel;

namespace boxprobe {

class QuietCombo;
class ValueField;

class SurfaceViewPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SurfaceViewPanel(QWidget* parent = nullptr);

  const SurfaceViewSettings& settings() const { return settings_; }
  void choose(int view);
  /// With its range, if that is locked.
  void show(const SurfaceViewSettings& settings);
  /// The range that the picture shows now.
  void showRange(const std::pair<double, double>& range);

 signals:
  void changed(const boxprobe::SurfaceViewSettings& settings);

 private:
  void lockRange();
  void apply();

  SurfaceViewSettings settings_;
  QuietCombo* combo_;
  QLabel* help_;
  QWidget* rangeRow_;
  ValueField *low_, *high_;
  QCheckBox* lock_;
};

/// "2.41 scene units", "+x", "0.2 0.5 0.7": a view's value of a pixel; why there is none where there is none.
QString surfaceViewReadout(const SurfaceViewRow& row, const Explanation& explanation);

}  // namespace boxprobe
