// See lesson_steps.h.
#include "tests/gui/lesson_steps.h"

#include <QDockWidget>
#include <QPixmap>
#include <QScreen>
#include <QScrollArea>
#include <QTest>
#include <QWindow>

#include "app/gui/lessons/lesson_progress.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/window/projector.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

std::string lessonFolder() {
  return std::string(BOXPROBE_DATA_DIR) + "/lessons";
}

void LessonWindowTest::SetUp() {
  forgetLessons();
  WindowTest::SetUp();
  window_->pictureWork().setRest(PictureWork::kRestMilliseconds);
  lessons().setFolder(lessonFolder());
  lessons().setLanguage("en");
}

void LessonWindowTest::TearDown() {
  window_->projector().setOn(false);
  lessons().leave();
  window_->findChild<QDockWidget*>("lessons")->close();  // its key opens it for the next one
  forgetLessons();
}

QAbstractButton* LessonWindowTest::button(const QString& name) {
  auto* found = window_->findChild<QAbstractButton*>(name);
  EXPECT_NE(found, nullptr) << name.toStdString();
  return found;
}

void LessonWindowTest::click(const QString& name) {
  QAbstractButton* target = button(name);
  ASSERT_NE(target, nullptr);
  for (QWidget* parent = target->parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
    if (auto* scroll = qobject_cast<QScrollArea*>(parent)) {
      QCoreApplication::processEvents();  // what was just shown has its place only then
      scroll->ensureWidgetVisible(target);
    }
  }
  QCoreApplication::processEvents();
  ASSERT_TRUE(target->isVisible()) << name.toStdString();
  ASSERT_TRUE(target->isEnabled()) << name.toStdString();
  QTest::mouseClick(target, Qt::LeftButton);
  QCoreApplication::processEvents();
}

QString LessonWindowTest::text(const QString& label) {
  auto* found = window_->findChild<QLabel*>(label);
  EXPECT_NE(found, nullptr) << label.toStdString();
  return found ? found->text() : QString();
}

bool LessonWindowTest::shown(const QString& name) {
  auto* found = window_->findChild<QWidget*>(name);
  return found != nullptr && found->isVisible();
}

void LessonWindowTest::openFromList(const std::string& lesson) {
  const QString name = "lesson:" + QString::fromStdString(lesson);
  if (!shown(name)) key(Qt::Key_F1);  // where the list is on show the key closes it
  click(name);
}

void LessonWindowTest::waitForMeasure() {
  waitUntilIdle();
  constexpr int kMilliseconds = 300000;
  ASSERT_TRUE(QTest::qWaitFor([this] { return !lessons().check().pending(); }, kMilliseconds)) << "never measured";
  waitUntilIdle();
}

void LessonWindowTest::edit(const std::vector<std::string>& assignments) {
  window_->editor().commit("Edit", [&](Scene& scene) { setSceneFields(scene, assignments); });
}

void LessonWindowTest::keepPicture(const QString& name) {
  const QString folder = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
  if (folder.isEmpty()) return;
  QCoreApplication::processEvents();
  window_->windowHandle()->screen()->grabWindow(window_->winId()).save(folder + "/" + name + ".png");
}

}  // namespace boxprobe
