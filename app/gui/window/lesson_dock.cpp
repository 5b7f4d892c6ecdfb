// See lesson_dock.h.
#include "app/gui/window/lesson_dock.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <algorithm>

#include "app/gui/lessons/lesson_panel.h"
#include "app/gui/lessons/lesson_view.h"
#include "app/gui/view/workspace.h"
#include "app/gui/window/projector.h"

namespace boxprobe {

LessonDock::LessonDock(Workspace& workspace, LessonView& lessons, QMainWindow* window)
    : QObject(window),
      lessons_(lessons),
      window_(window),
      dock_(new QDockWidget(QMainWindow::tr("Lessons"), window)),
      projector_(new Projector(workspace, window, dock_, lessons.panel())) {
  constexpr int kLessonWidth = 400;
  dock_->setObjectName("lessons");
  dock_->setWidget(lessons.panel());
  dock_->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
  window->addDockWidget(window->isRightToLeft() ? Qt::RightDockWidgetArea : Qt::LeftDockWidgetArea, dock_);
  // In the outliner's place while a lesson is open: beside both, little would be left of the picture.
  auto* outliner = window->findChild<QDockWidget*>("outliner");
  if (outliner != nullptr) window->tabifyDockWidget(outliner, dock_);
  dock_->hide();
  dock_->installEventFilter(this);
  connect(&lessons, &LessonView::shown, this, [this, window, outliner] {
    if (dock_->isHidden()) makeRoom();
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
  connect(workspace.actions().lessons, &QAction::triggered, this, &LessonDock::toggle);
}

void LessonDock::toggle() {
  const bool seen = dock_->isVisible() && !dock_->visibleRegion().isEmpty();
  if (lessons_.panel()->stepShown() || !seen || !dock_->close()) lessons_.showList();
}

// A window that is too narrow for text, picture and panels side by side would grow, perhaps beyond the screen: the text
// then shares the panels' place.
void LessonDock::makeRoom() {
  if (dock_->isFloating() || window_->dockWidgetArea(dock_) != Qt::LeftDockWidgetArea) return;
  constexpr int kBetween = 8;  // what can be dragged between docks
  QDockWidget* beside = nullptr;
  int panels = 0;
  const auto docks = window_->findChildren<QDockWidget*>();
  for (QDockWidget* dock : docks) {
    if (window_->dockWidgetArea(dock) != Qt::RightDockWidgetArea || dock->isFloating() || dock->isHidden()) continue;
    panels = std::max(panels, dock->minimumSizeHint().width() + kBetween);
    if (beside == nullptr || !dock->visibleRegion().isEmpty()) beside = dock;
  }
  const int text = dock_->minimumSizeHint().width() + kBetween;
  const int picture = window_->centralWidget() != nullptr ? window_->centralWidget()->minimumWidth() : 0;
  if (beside != nullptr && text + picture + panels > window_->width()) window_->tabifyDockWidget(beside, dock_);
}

bool LessonDock::eventFilter(QObject* watched, QEvent* event) {
  // A lesson whose text is gone would leave its scene behind.
  if (watched == dock_ && event->type() == QEvent::Close) lessons_.leave();
  return QObject::eventFilter(watched, event);
}

}  // namespace boxprobe
