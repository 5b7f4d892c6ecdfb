// See projector.h.
#include "app/gui/window/projector.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>

#include "app/gui/lessons/lesson_panel.h"
#include "app/gui/view/workspace.h"

namespace boxprobe {

namespace {

constexpr double kLessonShare = 0.34;  ///< of the screen's width
constexpr int kNarrowestLesson = 420;  ///< pixels
/// Letters in points, by the height of the screen: about forty lines fill it, so that the last row of seats can read.
double largeType(int height) {
  constexpr double kPointsPerPixel = 0.0185, kSmallest = 15.0, kLargest = 32.0;
  return std::clamp(height * kPointsPerPixel, kSmallest, kLargest);
}

}  // namespace

Projector::Projector(Workspace& workspace, QMainWindow* window, QDockWidget* lessonDock, LessonPanel* lessons)
    : QObject(window),
      action_(workspace.actions().projector),
      window_(window),
      lessonDock_(lessonDock),
      lessons_(lessons) {
  connect(action_, &QAction::toggled, this, &Projector::setOn);
  connect(&workspace, &Workspace::lessonShown, this, &Projector::setLessonOpen);
}

void Projector::setLessonOpen(bool open) {
  lessonOpen_ = open;
  if (!on_) return;
  lessonDock_->setVisible(open);
  if (open) showLessonLarge();
}

void Projector::showLessonLarge() {
  const QSize screen = window_->screen()->geometry().size();
  lessons_->setTypeSize(largeType(screen.height()));
  if (lessonDock_->titleBarWidget() == nullptr) lessonDock_->setTitleBarWidget(new QWidget(lessonDock_));
  lessonDock_->show();
  const int width = std::max(static_cast<int>(kLessonShare * screen.width()), kNarrowestLesson);
  window_->resizeDocks({lessonDock_}, {width}, Qt::Horizontal);
}

void Projector::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (on) {
    docks_ = window_->saveState();
    windowState_ = window_->windowState();
    for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) dock->hide();
    for (QToolBar* bar : window_->findChildren<QToolBar*>()) bar->hide();
    window_->menuBar()->hide();
    window_->statusBar()->hide();
    window_->showFullScreen();
    if (lessonOpen_) showLessonLarge();
  } else {
    QWidget* bare = lessonDock_->titleBarWidget();
    lessonDock_->setTitleBarWidget(nullptr);
    delete bare;
    lessons_->setTypeSize(LessonPanel::kUsualType);
    window_->setWindowState(windowState_);
    window_->show();
    window_->menuBar()->show();
    window_->statusBar()->show();
    window_->restoreState(docks_);
    if (lessonOpen_) lessonDock_->show();
  }
  action_->setChecked(on);
}

}  // namespace boxprobe
