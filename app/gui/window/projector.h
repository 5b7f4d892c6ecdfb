// The window for a projector: the picture and, while a lesson is open, its text in large letters; all else is put away
// and comes back as it was.
#pragma once

#include <QByteArray>
#include <QObject>

class QAction;
class QDockWidget;
class QMainWindow;

namespace boxprobe {

class LessonPanel;
class Workspace;

class Projector : public QObject {
  Q_OBJECT

 public:
  Projector(Workspace& workspace, QMainWindow* window, QDockWidget* lessonDock, LessonPanel* lessons);

  bool on() const { return on_; }
  void setOn(bool on);

 private:
  /// A lesson was opened or left.
  void setLessonOpen(bool open);
  void showLessonLarge();

  QAction* action_;
  QMainWindow* window_;
  QDockWidget* lessonDock_;
  LessonPanel* lessons_;
  QByteArray docks_;
  Qt::WindowStates windowState_;
  bool on_ = false, lessonOpen_ = false;
};

}  // namespace boxprobe
