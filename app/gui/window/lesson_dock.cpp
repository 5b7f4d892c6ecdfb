// See lesson_dock.h.
#include "app/gui/window/lesson_dock.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>

#include "app/gui/lessons/lesson_panel.h"
#include "app/gui/lessons/lesson_view.h"
#include "app/gui/window/projector.h"

namespace boxprobe {

LessonDock::LessonDock(LessonView& lessons, QMainWindow* window)
    : QObject(window),
      lessons_(lessons),
      dock_(new QDockWidget(QMainWindow::tr("Lessons"), window)),
      projector_(new Projector(window, dock_, lessons.panel())) {
  constexpr int kLessonWidth = 400;
  dock_->setObjectName("lessons");
  dock_->setWidget(lessons.panel());
  dock_->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  window->addDockWidget(Qt::LeftDockWidgetArea, dock_);
  window->resizeDocks({dock_}, {kLessonWidth}, Qt::Horizontal);
  dock_->hide();
  dock_->installEventFilter(this);
  connect(&lessons, &LessonView::shown, this, [this] {
    dock_->show();
    dock_->raise();
  });
  connect(&lessons, &LessonView::openChanged, projector_, &Projector::setLessonOpen);
}

bool LessonDock::eventFilter(QObject* watched, QEvent* event) {
  // A lesson whose text is gone would leave its scene behind.
  if (watched == dock_ && event->type() == QEvent::Close) lessons_.leave();
  return QObject::eventFilter(watched, event);
}

}  // namespace boxprobe
