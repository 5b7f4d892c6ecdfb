// See lesson_panel.h.
#include "app/gui/lessons/lesson_panel.h"

#include "app/gui/lessons/lesson_list_page.h"
#include "app/gui/lessons/lesson_step_page.h"

namespace boxprobe {

LessonPanel::LessonPanel(QWidget* parent)
    : QStackedWidget(parent), list_(new LessonListPage(this)), step_(new LessonStepPage(this)) {
  addWidget(list_);
  addWidget(step_);
  setTypeSize(kUsualType);
}

void LessonPanel::showList() {
  setCurrentWidget(list_);
}

void LessonPanel::showStep() {
  setCurrentWidget(step_);
}

bool LessonPanel::stepShown() const {
  return currentWidget() == step_;
}

void LessonPanel::setTypeSize(double points) {
  constexpr double kTitle = 1.35;
  // A style sheet, for the window's own keeps fonts from being handed down.
  setStyleSheet(QString("QWidget { font-size: %1pt } QLabel#stepTitle { font-size: %2pt; font-weight: bold }")
                    .arg(points)
                    .arg(kTitle * points));
}

}  // namespace boxprobe
