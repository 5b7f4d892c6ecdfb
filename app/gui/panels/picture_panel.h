// Exposure of the picture shown. Called by the main window.
#pragma once

#include <QWidget>

#include "app/gui/edit/editor.h"

class QSlider;

namespace boxprobe {

class ValueField;

class PicturePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PicturePanel(Editor& editor, QWidget* parent = nullptr);
  /// The document changed.
  void update();

 private:
  void preview(double exposure);
  void commit(double exposure);

  Editor& editor_;
  QSlider* slider_;  ///< in thirds of a stop
  ValueField* field_;
};

}  // namespace boxprobe
