// Exposure as a slider in stops and a number: in the panel *Picture* and in the tool bar. Dragged, the picture follows;
// one undo step. Called by both; edits the document through the editor.
#pragma once

#include <QTimer>
#include <QWidget>

#include "app/gui/edit/editor.h"

class QSlider;

namespace boxprobe {

class ValueField;

class ExposureControl : public QWidget {
  Q_OBJECT

 public:
  explicit ExposureControl(Editor& editor, QWidget* parent = nullptr);

  /// The document changed.
  void update();
  /// Brighter, or darker where `stops` is below 0. Steps that follow each other soon are one undo step.
  void step(double stops);
  /// What slider and number mean, for a label beside them.
  static QString toolTipText();

 private:
  void preview(double exposure);
  void commit(double exposure);

  Editor& editor_;
  QSlider* slider_;  ///< in tenths of a stop
  ValueField* field_;
  QTimer rest_;  ///< since the last step
};

}  // namespace boxprobe
