// Pictures of the window in its states, for people to look at: as opened, two probes with their influence, the error
// with the worst face, the picture beside the ray-traced reference, four views side by side, several probes selected,
// a pixel explained, the light theme, a small screen, the menus, the other docks, a lesson's task and letters at 200 %.
//   xvfb-run -a -s "-screen 0 3200x2000x24 -noreset" build/release/tests/gui/window_pictures
// They are written to out/window, or to the folder that BOXPROBE_PICTURES names; of another scene than `building` with
// BOXPROBE_PICTURES_SCENE.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QProcessEnvironment>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <cstdio>

#include "app/gui/edit/probe_gauge.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/lessons/lesson_view.h"
#include "app/gui/panels/place_panel.h"
#include "app/gui/view/picture_compare.h"
#include "app/gui/view/view_comparison.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/window_style.h"
#include "app/gui/window/view_tools.h"
#include "filters/vtk/widgets/handle.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class WindowPictures : public WindowTest {
 protected:
  LoadedScene scene() const override {
    const QString other = qEnvironmentVariable("BOXPROBE_PICTURES_SCENE");
    return loadScene(other.isEmpty() ? buildingPath() : other.toStdString());
  }
  void size(int width, int height) {
    window_->resize(width, height);
    waitUntilIdle();
  }
  void keep(const char* name) {
    const QString folder = qEnvironmentVariable("BOXPROBE_PICTURES", "out/window");
    ASSERT_TRUE(QDir().mkpath(folder)) << folder.toStdString() << ": cannot be made";
    waitUntilIdle();
    const QString path = QDir(folder).filePath(QString(name) + ".png");
    ASSERT_TRUE(window_->grab().save(path)) << path.toStdString() << ": cannot be written";
    std::printf("%s\n", path.toStdString().c_str());
  }
};

TEST_F(WindowPictures, WelcomeAndInspectors) {
  const auto tabs = window_->findChild<QTabWidget*>("inspectors");
  for (const auto& [theme, look] : {std::pair(Theme::Dark, "dark"), std::pair(Theme::Light, "light")}) {
    applyWindowStyle(*qApp, theme);
    for (const auto& [width, height] : {std::pair(1440, 900), std::pair(1024, 700)}) {
      const std::string ending = std::string("-") + look + "-" + std::to_string(width);
      window_->showScene(scene());
      window_->resizeDocks({window_->findChild<QDockWidget*>("outliner")}, {230}, Qt::Horizontal);
      size(width, height);
      for (int i = 0; i < tabs->count(); ++i) {
        tabs->setCurrentIndex(i);
        keep((tabs->tabText(i).toLower().toStdString() + ending).c_str());
      }
      tabs->setCurrentIndex(0);
      window_->showScene(LoadedScene());
      QTest::qWait(2000);  // for its thumbnails
      keep(("welcome" + ending).c_str());
    }
  }
  applyWindowStyle(*qApp, Theme::Dark);
}

TEST_F(WindowPictures, Placed) {
  size(1440, 900);
  auto* panel = window_->findChild<PlacePanel*>();
  key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(QTest::qWaitFor([panel] { return !panel->running(); }, 900000));
  auto* apply = window_->findChild<QPushButton*>("applyPlaced");
  for (QWidget* above = apply->parentWidget(); above != nullptr; above = above->parentWidget()) {
    if (auto* area = qobject_cast<QScrollArea*>(above))
      area->ensureWidgetVisible(window_->findChild<QWidget*>("placedProbes"), 0, 300);
  }
  keep("placed");
  auto* thumbnail = window_->findChild<QToolButton*>("placedPicture0");
  ASSERT_NE(thumbnail, nullptr);
  thumbnail->click();
  auto* dialog = window_->findChild<QDialog*>("placedPictures");
  ASSERT_NE(dialog, nullptr);
  QTest::qWait(200);
  ASSERT_TRUE(
      dialog->grab().save(QDir(qEnvironmentVariable("BOXPROBE_PICTURES", "out/window")).filePath("placed-large.png")));
  dialog->close();
}

TEST_F(WindowPictures, AtOneToOne) {
  size(1440, 900);
  keep("as-opened");

  window_->probeWidget().setMode(HandleMode::Influence);
  Probe second = probe();
  second.name = "second";
  second.origin.z += 2.0;
  second.box.min.z = 0.0;
  second.influence.reset();
  window_->editor().commit("Add probe", [second](Scene& scene) {
    scene.probes.front().box.max.z = 0.0;
    scene.probes.front().influence.reset();
    scene.probes.push_back(second);
  });
  keep("two-probes-influence");
  window_->editor().undo();
  window_->probeWidget().setMode(HandleMode::Box);

  // A face a metre too far out: it is marked, and the picture shows where that tells.
  const Probe right = probe();
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.min.z -= 1.0; });
  auto* gauge = window_->findChild<ProbeGauge*>();
  ASSERT_TRUE(QTest::qWaitFor([gauge] { return gauge->current(); }, 120000));
  keep("worst-face");
  const auto* caption = window_->findChild<QLabel*>("compareRight");
  key(Qt::Key_V, Qt::ShiftModifier);
  ASSERT_TRUE(QTest::qWaitFor([caption] { return caption->text() == "Difference: Path traced"; }, 600000));
  keep("error-worst-face");
  key(Qt::Key_Escape);
  window_->editor().undo();

  key(Qt::Key_C, Qt::ShiftModifier);
  const auto* numbers = window_->findChild<QLabel*>("compareNumbers");
  ASSERT_TRUE(QTest::qWaitFor([numbers] { return !numbers->text().isEmpty(); }, 120000));
  keep("beside-the-reference");
  window_->tools().compare().stop();

  window_->editor().commit("Add probes", [right](Scene& scene) {
    for (int i = 1; i < 3; ++i) {
      Probe more = right;
      more.name = "more " + std::to_string(i);
      more.box = {right.box.min * 0.5, right.box.max * 0.5};
      more.origin.z += 1.5 * i;
      more.intensity = i;
      scene.probes.push_back(more);
    }
  });
  key(Qt::Key_A, Qt::ControlModifier);
  window_->probeWidget().setMode(HandleMode::Place);
  keep("several-probes");
  window_->probeWidget().setMode(HandleMode::Box);
  window_->editor().undo();

  key(Qt::Key_E);
  const QPointF floor(0.655 * window_->viewport().width(), 0.73 * window_->viewport().height());
  move(floor);
  press(floor);
  release(floor);
  keep("explain");
  key(Qt::Key_E);

  applyWindowStyle(*qApp, Theme::Light);
  key(Qt::Key_E);
  const QPointF middle(0.5 * window_->viewport().width(), 0.75 * window_->viewport().height());
  move(middle);
  press(middle);
  release(middle);
  keep("light-theme");
  key(Qt::Key_E);
  applyWindowStyle(*qApp);

  window_->findChild<QDockWidget*>("probes")->raise();
  size(1280, 800);
  keep("1280x800");
}

// Smaller, and as soon as there are numbers: paths take minutes.
TEST_F(WindowPictures, FourViews) {
  size(1200, 720);
  key(Qt::Key_C, Qt::AltModifier);
  ViewComparison& views = window_->tools().sideBySide();
  ASSERT_TRUE(
      QTest::qWaitFor([&views] { return !views.making() && views.views().numbers(0).contains("RMSE"); }, 1800000));
  keep("four-views");
  views.setOn(false);
}

TEST_F(WindowPictures, TheReflectionAlone) {
  size(1080, 680);
  window_->tools().compare().traceReference(TracedLight::Reflection);
  const auto* caption = window_->findChild<QLabel*>("compareRight");
  const auto* numbers = window_->findChild<QLabel*>("compareNumbers");
  ASSERT_TRUE(QTest::qWaitFor(
      [=] { return caption->text() == "Reflection traced" && numbers->text().contains("RMSE"); }, 1800000));
  keep("reflection-alone");
  key(Qt::Key_V);
  keep("reflection-alone-whole");
  key(Qt::Key_V);
  window_->tools().compare().stop();
}

TEST_F(WindowPictures, MenusAndDocks) {
  size(1440, 900);
  for (QAction* action : window_->menuBar()->actions()) {
    QMenu* menu = action->menu();
    menu->popup(window_->mapToGlobal(QPoint(0, 30)));
    const QString name = "menu-" + QString(action->text()).remove('&').toLower();
    QCoreApplication::processEvents();
    const QString folder = qEnvironmentVariable("BOXPROBE_PICTURES", "out/window");
    QDir().mkpath(folder);
    EXPECT_TRUE(menu->grab().save(QDir(folder).filePath(name + ".png")));
    menu->hide();
  }
  for (const char* name : {"cubemap", "debug", "cost", "frame"}) {
    auto* dock = window_->findChild<QDockWidget*>(name);
    dock->show();
    dock->raise();
    QTest::qWait(1500);  // the cubemap is read a face at a time
    keep(name);
  }
  window_->findChild<QDockWidget*>("probes")->raise();
}

TEST_F(WindowPictures, ALessonsTask) {
  size(1440, 900);
  window_->lessons().open("fit-the-box", 2);
  const auto* value = window_->findChild<QLabel*>("taskValue");
  ASSERT_TRUE(QTest::qWaitFor([value] { return value->text().contains("done below"); }, 120000));
  keep("lesson-task");
  window_->lessons().leave();
}

TEST_F(WindowPictures, AtTwice) {
  if (qApp->devicePixelRatio() < 1.5) {
    QProcess child;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_SCALE_FACTOR", "2");
    child.setProcessEnvironment(environment);
    child.start(QCoreApplication::applicationFilePath(), {"--gtest_filter=WindowPictures.AtTwice"});
    ASSERT_TRUE(child.waitForFinished(600000));
    ASSERT_EQ(child.exitCode(), 0) << child.readAllStandardOutput().toStdString();
    return;
  }
  size(1280, 800);  // 2560 x 1600 of the screen
  keep("at-200-percent");
}

}  // namespace
}  // namespace boxprobe
