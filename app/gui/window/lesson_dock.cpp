// See lesson_dock.h.
#include "app/gui/window/lesson_dock.h"

#include <QAction>
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
  // In the outliner's place while a lesson is open: beside both, little would be left of the picture.
  auto* outliner = window->findChild<QDockWidget*>("outliner");
  if (outliner != nullptr) window->tabifyDockWidget(outliner, dock_);
  dock_->hide();
  dock_->installEventFilter(this);
  connect(&lessons, &LessonView::shown, this, [this, window, outliner] {
    const bool opens = !dock_->isVisible();
    if (opens && outliner != nullptr) outlinerWidth_ = outliner->width();
    dock_->show();
    dock_->raise();
    if (opens) window->resizeDocks({dock_}, {kLessonWidth}, Qt::Horizontal);
  });
  connect(dock_->toggleViewAction(), &QAction::toggled, this, [this, window, outliner](bool shown) {
    if (!shown && outliner != nullptr && outlinerWidth_ > 0 && !projector_->on()) {
      window->resizeDocks({outliner}, {outlinerWidth_}, Qt::Horizontal);
    }
  });
  connect(&lessons, &LessonView::openChanged, projector_, &Projector::setLessonOpen);
}

bool LessonDock::eventFilter(QObject* watched, QEvent* event) {
  // A lesson whose text is gone would leave its scene behind.
  if (watched == dock_ && event->type() == QEvent::Close) lessons_.leave();
  return QObject::eventFilter(watched, event);
}

}  // namespace boxprobe
