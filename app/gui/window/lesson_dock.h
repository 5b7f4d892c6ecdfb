// The place of the lessons in the window: the dock with their text, and the projector's view of it.
#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;

namespace boxprobe {

class LessonView;
class Projector;
class Workspace;

class LessonDock : public QObject {
  Q_OBJECT

 public:
  /// Hidden at first, at the window's left.
  LessonDock(Workspace& workspace, LessonView& lessons, QMainWindow* window);
  Projector& projector() { return *projector_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The list of lessons: from a lesson's page, or shown, or away with it.
  void toggle();
  void makeRoom();

  LessonView& lessons_;
  QMainWindow* window_;
  QDockWidget* dock_;
  Projector* projector_;
  int outlinerWidth_ = 0;  ///< before a lesson took its place
};

}  // namespace boxprobe
