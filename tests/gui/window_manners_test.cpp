// What is expected of every window: menus that name each command and key once, questions in their place, nothing shown
// that only the program's authors read.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressDialog>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <atomic>
#include <chrono>
#include <map>
#include <thread>

#include "app/gui/edit/work_beside.h"
#include "app/gui/panels/bake_panel.h"
#include "app/gui/panels/outliner.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/file_commands.h"
#include "filters/core/scene/surface_view.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/handle_drag.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class WindowMannersTest : public WindowTest {
 protected:
  QTemporaryDir folder_;
};

TEST_F(WindowMannersTest, NoTwoCommandsShareAKey) {
  std::map<QString, QString> commands;
  for (const QAction* action : window_->findChildren<QAction*>()) {
    for (const QKeySequence& keys : action->shortcuts()) {
      const QString text = keys.toString();
      // The line of a text field has the usual keys of its own, while it has the focus.
      if (text.isEmpty() || action->shortcutContext() != Qt::WindowShortcut) continue;
      if (qobject_cast<QLineEdit*>(action->parent()) != nullptr) continue;
      EXPECT_EQ(commands.count(text), 0u)
          << text.toStdString() << ": " << commands[text].toStdString() << ", " << action->text().toStdString();
      commands[text] = action->text();
    }
  }
  EXPECT_GT(commands.size(), 50u);
}

TEST_F(WindowMannersTest, CountersOfWorkAreShownOnlyWhenAskedFor) {
  auto* counters = window_->findChild<QLabel*>("workCounters");
  auto* shown = window_->findChild<QAction*>("countersShown");
  ASSERT_TRUE(counters != nullptr && shown != nullptr);
  EXPECT_FALSE(counters->isVisible());
  shown->trigger();
  EXPECT_TRUE(counters->isVisible());
  EXPECT_TRUE(counters->text().contains("faces"));
  shown->trigger();
  EXPECT_FALSE(counters->isVisible());
}

TEST_F(WindowMannersTest, TheDebugMenuHasEveryViewOfTheSurfaces) {
  const auto actions = window_->findChild<QMenu*>("surfaceViews")->actions();
  ASSERT_EQ(static_cast<std::size_t>(actions.size()), surfaceViews().size());
  auto* combo = window_->findChild<QComboBox*>("surfaceView");
  window_->viewport().setFocus();
  key(Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(combo->currentIndex(), 1);
  EXPECT_TRUE(actions[1]->isChecked());
  EXPECT_FALSE(actions[0]->isChecked());
  waitUntilIdle();
  key(Qt::Key_0, Qt::AltModifier);
  EXPECT_EQ(combo->currentIndex(), 0);
  EXPECT_TRUE(actions[0]->isChecked());
  waitUntilIdle();
}

TEST_F(WindowMannersTest, ABrokenFileAsksNothingAboutUnsavedChanges) {
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x = 3.0; });
  QFile file(folder_.filePath("bad.boxprobe.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{ not JSON");
  file.close();
  const auto first = answerMessageBox(QString("OK"));
  EXPECT_FALSE(window_->files().openPath(file.fileName()));
  EXPECT_TRUE(first->text.contains("bad.boxprobe.json")) << first->text.toStdString();
  EXPECT_EQ(probe().box.max.x, 3.0);
  document().undo();
}

TEST_F(WindowMannersTest, AddWithoutASceneSaysWhatToDo) {
  window_->showScene(LoadedScene());
  QTest::mouseClick(window_->findChild<QToolButton*>("Add"), Qt::LeftButton);
  EXPECT_TRUE(document().scene().probes.empty());
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains("open a model"))
      << window_->statusBar()->currentMessage().toStdString();
}

TEST_F(WindowMannersTest, BakedFilesThatNoLongerHoldAreToldWhenTheSceneIsOpened) {
  const std::string path = folder_.filePath("copy.boxprobe.json").toStdString();
  saveSceneFile(document().scene(), path);
  window_->showScene(loadScene(path));
  waitUntilIdle();
  const auto question = answerMessageBox(QMessageBox::Save);
  window_->findChild<BakePanel*>()->saveBaked();
  ASSERT_TRUE(waitFor([this] { return window_->statusBar()->currentMessage().startsWith("Wrote"); }));
  const auto told = [&path] {
    MainWindow second;
    QString said;
    QObject::connect(second.statusBar(), &QStatusBar::messageChanged, [&said](const QString& text) {
      if (text.contains("baked files")) said = text;
    });
    second.showScene(loadScene(path));
    second.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&second, 60000));
    EXPECT_TRUE(waitFor([&] { return second.scheduler().idle() && !second.renderer().workPending(); }));
    return said;
  };
  EXPECT_EQ(told(), "") << "files that hold are nothing to tell";
  Scene moved = loadSceneFile(path);
  moved.probes.front().origin.x += 0.5;
  saveSceneFile(moved, path);
  const QString said = told();
  EXPECT_TRUE(said.startsWith("1 of 1 baked files")) << said.toStdString();
}

// The picture stands between two columns of panels: a window that is taller than wide would leave it a slit.
TEST_F(WindowMannersTest, ANewWindowIsWideAndFitsASmallScreen) {
  const MainWindow second;
  EXPECT_GE(second.width(), 4 * second.height() / 3);
  EXPECT_LE(second.width(), 1600);
  EXPECT_LE(second.height(), 1000);
  EXPECT_GE(second.width(), 1024);
  EXPECT_GE(second.height(), 700);
}

TEST_F(WindowMannersTest, ALongListOfProbesCanBeSearched) {
  auto* filter = window_->findChild<QLineEdit*>("outlinerFilter");
  window_->editor().commit("Many", [](Scene& scene) {
    for (int i = 0; i < 9; ++i) {
      Probe more = movedProbe(scene.probes.front(), {0.1 * (i + 1), 0.0, 0.0});
      more.name = (i % 3 == 0 ? "hall " : "bath ") + std::to_string(i);
      scene.probes.push_back(more);
    }
  });
  filter->setFocus();
  QTest::keyClicks(filter, "hall");
  EXPECT_EQ(window_->findChild<Outliner*>()->model().probesShown().size(), 3u);
  if (const char* out = std::getenv("BOXPROBE_TEST_OUTPUT")) {
    waitUntilIdle();
    window_->grab().save(QString(out) + "/filter.png");
  }
  filter->clear();
  document().undo();
}

// Whoever closes it would edit what the work is about to replace.
TEST_F(WindowMannersTest, AWaitCannotBeClosedAwayAndNothingElseBeginsMeanwhile) {
  for (const bool stoppable : {false, true}) {
    std::atomic<bool> mayEnd{false};
    bool seen = false, stopped = false;
    QTimer closing;
    QObject::connect(&closing, &QTimer::timeout, [&] {
      auto* dialog = qobject_cast<QProgressDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || seen) return;
      seen = true;
      QTest::keyClick(dialog, Qt::Key_Escape);
      dialog->close();
      EXPECT_TRUE(dialog->isVisible());
      EXPECT_TRUE(workBesideRuns());
      EXPECT_FALSE(window_->files().openPath(QString::fromStdString(buildingPath())));
      mayEnd = true;
    });
    closing.start(10);
    workBeside(window_, "Test", stoppable, [&](const BesideProgress& progress) {
      while (!mayEnd) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      stopped = !progress(0.5);
    });
    EXPECT_TRUE(seen);
    EXPECT_EQ(stopped, stoppable);
    EXPECT_FALSE(workBesideRuns());
  }
}

}  // namespace
}  // namespace boxprobe
