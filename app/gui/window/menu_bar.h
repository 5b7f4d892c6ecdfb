// Arranges the actions in the menus and the tool bar, and carries out those that no part has as its own.
#pragma once

#include <QObject>

class QMainWindow;

namespace boxprobe {

class Workspace;

class MenuBar : public QObject {
  Q_OBJECT

 public:
  MenuBar(Workspace& workspace, QMainWindow* window);

 private:
  void arrange(QMainWindow* window);
  /// The document changed: labels of undo and redo, what can be chosen.
  void update();
  void nameProbeActions();
  void fillHistory();

  Workspace& workspace_;
};

}  // namespace boxprobe
