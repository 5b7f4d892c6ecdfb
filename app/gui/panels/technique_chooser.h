// The technique of a probe: where the reflected ray hits, and how the lobe around it is looked up, chosen apart as the
// tables have them. Nothing in this file knows a technique by name. Called by the probe panel; knows no document.
#pragma once

#include <QWidget>
#include <string>

class QComboBox;

namespace boxprobe {

/// The technique of that id with another row of projectionRows(); an evaluation that does not go with it gives way to
/// the plainest one.
std::string withProjection(const std::string& techniqueId, int projection);
/// The technique of that id with another row of evaluationRows(); a projection that does not go with it gives way to
/// the one that the evaluation means by itself.
std::string withEvaluation(const std::string& techniqueId, int evaluation);

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
  /// One of the two, and nothing of the other: row of projectionRows() or evaluationRows().
  void projectionChosen(int projection);
  void evaluationChosen(int evaluation);

 private:
  void enableWhatCombines();

  QComboBox* projection_;  ///< item data: row of projectionRows()
  QComboBox* evaluation_;  ///< item data: row of evaluationRows()
};

}  // namespace boxprobe
