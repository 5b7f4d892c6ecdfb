// Exposure of the picture shown. Called by the main window.
#pragma once

#include <QWidget>

#include "app/gui/edit/editor.h"

namespace boxprobe {

class ExposureControl;

class PicturePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PicturePanel(Editor& editor, QWidget* parent = nullptr);
  /// The document changed.
  void update();

 private:
  ExposureControl* exposure_;
};

}  // namespace boxprobe
