// Unsaved changes outlive the process that held them, and nothing else does; the history lists the steps and goes to
// each.
#include "app/gui/window/recovery.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QMenu>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "app/gui/window/autosave.h"
#include "app/gui/window/file_commands.h"
#include "filters/io/scene/scene_file.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class RecoveryTest : public WindowTest {
 protected:
  void SetUp() override {
    for (const Autosave::Kept& kept : Autosave::leftBehind()) Autosave::discard(kept);
    WindowTest::SetUp();
  }
  void edit(double x) {
    window_->editor().commitProbe("Set box", [x](Probe& edited) { edited.box.max.x = x; });
  }
};

// Of another process, which TheChangesOfAKilledProcessAreOffered starts: edits, and is killed.
TEST_F(RecoveryTest, DISABLED_EditsAndIsKilled) {
  edit(2.75);
  ASSERT_TRUE(window_->autosave().write());
  edit(2.5);  // taken back again: what was kept last counts
  document().undo();
  ASSERT_TRUE(window_->autosave().write());
  raise(SIGKILL);
}

TEST_F(RecoveryTest, TheChangesOfAKilledProcessAreOffered) {
  QProcess child;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("BOXPROBE_TEST_PREFERENCES", qEnvironmentVariable("XDG_DATA_HOME"));
  child.setProcessEnvironment(environment);
  child.start(QCoreApplication::applicationFilePath(),
              {"--gtest_also_run_disabled_tests", "--gtest_filter=RecoveryTest.DISABLED_EditsAndIsKilled"});
  ASSERT_TRUE(child.waitForFinished(120000));
  ASSERT_EQ(child.exitStatus(), QProcess::CrashExit) << child.readAllStandardOutput().toStdString();
  ASSERT_EQ(Autosave::leftBehind().size(), 1u);

  // Asked later: it is still there.
  const auto first = answerMessageBox(QString("Ask later"));
  offerRecovery(*window_);
  EXPECT_TRUE(first->text.contains("building.boxprobe.json")) << first->text.toStdString();
  EXPECT_FALSE(window_->isWindowModified());

  const auto second = answerMessageBox(QString("Recover"));
  offerRecovery(*window_);
  EXPECT_EQ(probe().box.max.x, 2.75);
  EXPECT_TRUE(window_->isWindowModified()) << "the file does not have it yet";
  EXPECT_FALSE(document().canUndo());
  EXPECT_EQ(document().path(), buildingPath());
  EXPECT_EQ(window_->models().size(), 1u) << "the model is found from the folder of the kept scene";
  EXPECT_TRUE(Autosave::leftBehind().empty()) << "this process holds it now";

  // Saved, it reads back equal, and nothing is kept any more.
  const QTemporaryDir folder;
  const auto dialog = answerFileDialog(folder.filePath("saved.boxprobe.json"));
  ASSERT_TRUE(window_->files().saveAs());
  EXPECT_TRUE(loadSceneFile(document().path()) == document().scene());
  window_->autosave().write();
  const QDir all(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/unsaved");
  EXPECT_TRUE(all.entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
}

TEST_F(RecoveryTest, DamagedLeftoversAreRefusedInOneLineAndCanBeGivenUp) {
  edit(2.75);
  ASSERT_TRUE(window_->autosave().write());
  EXPECT_TRUE(Autosave::leftBehind().empty()) << "this process lives";
  // As if another process had left it.
  const QDir all(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/unsaved");
  const QString mine = all.filePath(all.entryList(QDir::Dirs | QDir::NoDotAndDotDot).value(0));
  const QString other = all.filePath("0-other");
  QDir().mkpath(other);
  QFile::copy(mine + "/about.json", other + "/about.json");
  QFile scene(other + "/scene.boxprobe.json");
  ASSERT_TRUE(scene.open(QIODevice::WriteOnly));
  scene.write("{ not JSON");
  scene.close();
  ASSERT_EQ(Autosave::leftBehind().size(), 1u);

  document().undo();
  const Scene before = document().scene();
  const auto refused = answerMessageBox(QMessageBox::Ok);
  EXPECT_FALSE(window_->files().recover(other + "/scene.boxprobe.json", {}));
  EXPECT_TRUE(refused->text.contains("not valid JSON")) << refused->text.toStdString();
  EXPECT_TRUE(document().scene() == before);

  const auto given = answerMessageBox(QString("Discard them"));
  offerRecovery(*window_);
  EXPECT_TRUE(Autosave::leftBehind().empty());
}

TEST_F(RecoveryTest, TheHistoryGoesToAnyStep) {
  const Scene opened = document().scene();
  for (const double x : {2.5, 2.6, 2.7}) edit(x);
  auto* history = window_->findChild<QMenu*>("history");
  ASSERT_TRUE(history != nullptr);
  const auto choose = [&](int row) {
    emit history->aboutToShow();
    history->actions().at(row)->trigger();
    QCoreApplication::processEvents();
  };
  emit history->aboutToShow();
  ASSERT_EQ(history->actions().size(), 4);
  EXPECT_TRUE(history->actions()[0]->isChecked());
  EXPECT_EQ(history->actions()[3]->text(), "As opened");
  choose(2);
  EXPECT_EQ(probe().box.max.x, 2.5);
  choose(3);
  EXPECT_TRUE(document().scene() == opened);
  EXPECT_FALSE(window_->isWindowModified());
  choose(0);
  EXPECT_EQ(probe().box.max.x, 2.7);
}

}  // namespace
}  // namespace boxprobe
