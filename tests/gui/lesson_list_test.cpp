// The list of lessons in its dock: as long as its lessons are.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QScrollArea>
#include <QTest>

#include "app/gui/lessons/lesson_list_page.h"
#include "app/gui/lessons/lesson_view.h"
#include "app/gui/widgets/text_button.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class LessonListTest : public WindowTest {};

TEST_F(LessonListTest, EndsWithItsLastLesson) {
  window_->showLessons();
  waitUntilIdle();
  auto* list = window_->findChild<LessonListPage*>();
  auto* area = list->findChild<QScrollArea*>();
  const QWidget* content = area->widget();
  for (const int width : {280, 420}) {
    window_->resizeDocks({window_->findChild<QDockWidget*>("lessons")}, {width}, Qt::Horizontal);
    QTest::qWait(50);
    int bottom = 0;
    const auto buttons = content->findChildren<TextButton*>();
    ASSERT_GT(buttons.size(), 20);
    for (const TextButton* button : buttons) {
      EXPECT_GE(button->height(), button->heightForWidth(button->width())) << "all of its text is seen";
      bottom = std::max(bottom, button->geometry().bottom());
    }
    EXPECT_LT(content->height() - bottom, 40) << "and nothing follows the last one, " << width << " wide";
  }
  window_->findChild<QDockWidget*>("lessons")->close();
}

}  // namespace
}  // namespace boxprobe
