// The technique of a probe: where the reflected ray hits, and how the lobe around it is looked up, chosen apart as the
// tables have them. Nothing in this file knows a technique by name. Called by the probe panel; knows no document.
#pragma once

#include <QWidget>
#include <string>

class QComboBox;

namespace boxprobe {

class TechniqueChooser : public QWidget {
  Q_OBJECT

 public:
  explicit TechniqueChooser(QWidget* parent = nullptr);

  void show(const std::string& techniqueId);
  /// The selected probes do not agree in one or the other.
  void showDiffers(bool projections, bool evaluations);
  /// What the current technique does, in a line or two.
  QString help() const;
  QComboBox* projection() const { return projection_; }
  QComboBox* evaluation() const { return evaluation_; }

 signals:
  /// Shortest id that parses back.
  void chosen(const std::string& techniqueId);

 private:
  void choose();
  void enableWhatCombines();

  QComboBox* projection_;  ///< item data: row of projectionRows()
  QComboBox* evaluation_;  ///< item data: row of evaluationRows()
};

}  // namespace boxprobe
