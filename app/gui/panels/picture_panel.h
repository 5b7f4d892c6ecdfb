// Exposure of the picture shown.
#pragma once

#include <QWidget>

#include "app/gui/edit/editor.h"

namespace boxprobe {

class ExposureControl;
class Workspace;

class PicturePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PicturePanel(Workspace& workspace);
};

}  // namespace boxprobe
