// The place of the lessons in the window: the dock with their text, and the projector's view of it. Called by the main
// window.
#pragma once

#include <QObject>

class QDockWidget;
class QMainWindow;

namespace boxprobe {

class LessonView;
class Projector;

class LessonDock : public QObject {
  Q_OBJECT

 public:
  /// Hidden at first, at the window's left.
  LessonDock(LessonView& lessons, QMainWindow* window);
  /// Away with it, as its own button does; false where it is not seen.
  bool close();
  Projector& projector() { return *projector_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeRoom();

  LessonView& lessons_;
  QMainWindow* window_;
  QDockWidget* dock_;
  Projector* projector_;
  int outlinerWidth_ = 0;  ///< before a lesson took its place
};

}  // namespace boxprobe
