// The controls of the rays: where they start, which lines, which colours, how many and how long. Called by the debug
// view; knows no renderer.
#pragma once

#include <QWidget>
#include <array>
#include <string>
#include <vector>

#include "app/gui/explain/ray_settings.h"

class QCheckBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace boxprobe {

class QuietCombo;
class ValueField;

class RayPanel : public QWidget {
  Q_OBJECT

 public:
  explicit RayPanel(QWidget* parent = nullptr);

  const RaySettings& settings() const { return settings_; }
  void show(const RaySettings& settings);
  void setObjects(const std::vector<std::string>& names);
  /// In scene units: how far rays go that hit nothing.
  void setMaximumLength(double length);
  void showStatus(const QString& line);

 signals:
  void changed(const boxprobe::RaySettings& settings);
  void clearRequested();
  void saveRequested();

 private:
  void buildKinds(QFormLayout* form);
  void apply();

  RaySettings settings_;
  QCheckBox* shown_;
  QuietCombo* source_;
  QuietCombo* object_;
  QSpinBox* count_;
  ValueField* length_;
  std::array<QCheckBox*, kRayKinds> kinds_{};
  QuietCombo* coloring_;
  QLabel* status_;
  QPushButton* clear_;
};

}  // namespace boxprobe
