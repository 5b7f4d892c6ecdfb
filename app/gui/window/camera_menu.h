// The menu of the scene's cameras: to look through them, and to store, move, rename and delete them.
#pragma once

#include <QObject>
#include <string>
#include <vector>

class QWidget;

namespace boxprobe {

class Workspace;

class CameraMenu : public QObject {
  Q_OBJECT

 public:
  CameraMenu(Workspace& workspace, QWidget* window);

 private:
  void update();
  void fill();
  /// Asks for a name; nothing if the user wants none.
  void store();
  void rename(int index);

  Workspace& workspace_;
  QWidget* window_;
  std::vector<std::string> names_;  ///< of the cameras in the menu
};

}  // namespace boxprobe
