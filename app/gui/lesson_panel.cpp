// See lesson_panel.h.
#include "app/gui/lesson_panel.h"

#include "app/gui/lesson_list_page.h"
#include "app/gui/lesson_step_page.h"

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
  QFont letters = font();
  letters.setPointSizeF(points);
  setFont(letters);
  step_->setTypeSize(points);
}

}  // namespace boxprobe
