// Exposure, tone mapping and background at hand beside the picture: in the tool bar, and by menu and keys.
#pragma once

#include <QObject>

class QMainWindow;
class QWidget;

namespace boxprobe {

class ExposureControl;
class Workspace;

class ExposureTools : public QObject {
  Q_OBJECT

 public:
  /// Adds to the window's tool bar.
  ExposureTools(Workspace& workspace, QMainWindow* window);

 private:
  void observe(QWidget* window);
  /// The document changed.
  void update();
  void setBackground(int chosen, QWidget* over);

  Workspace& workspace_;
  ExposureControl* control_;
};

}  // namespace boxprobe
