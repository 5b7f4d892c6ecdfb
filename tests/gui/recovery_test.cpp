// Unsaved changes outlive the process that held them, and nothing else does; the history lists the steps and goes to
// each.
#include "app/gui/window/recovery.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "app/gui/widgets/preferences.h"
#include "app/gui/widgets/settings_file.h"
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
  static QByteArray bytesOfFile(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
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
  const QString folderShown = QDir::toNativeSeparators(QFileInfo(QString::fromStdString(buildingPath())).path());
  EXPECT_TRUE(first->text.contains("building.boxprobe.json in " + folderShown)) << first->text.toStdString();
  EXPECT_TRUE(first->plain);
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
  EXPECT_FALSE(window_->files().recover(Autosave::leftBehind().front()));
  EXPECT_TRUE(refused->text.contains("not valid JSON")) << refused->text.toStdString();
  EXPECT_TRUE(document().scene() == before);

  const auto given = answerMessageBox(QString("Discard them"));
  offerRecovery(*window_);
  EXPECT_TRUE(Autosave::leftBehind().empty());
}

// What a process that was killed left: `about` beside the room's scene, its box wider by the metre.
class LeftBehindTest : public RecoveryTest {
 protected:
  void leave(const QByteArray& about) {
    const QDir all(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/unsaved");
    const QString folder = all.filePath("1-1");
    QDir().mkpath(folder);
    Scene scene = loadSceneFile(roomPath().toStdString());
    scene.probes.front().box.max.x = 5.0;
    saveSceneFile(scene, (folder + "/scene.boxprobe.json").toStdString());
    QFile file(folder + "/about.json");
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(about);
  }
  static QString roomPath() { return QString(BOXPROBE_DATA_DIR) + "/scenes/room.boxprobe.json"; }
  QTemporaryDir folder_;
};

TEST_F(LeftBehindTest, ARelativeNameIsNobodysFileAndIsNeverWritten) {
  // The folder this process happens to run in has a file of that name.
  const QString before = QDir::currentPath();
  QDir::setCurrent(folder_.path());
  saveSceneFile(loadSceneFile(roomPath().toStdString()), "room.boxprobe.json");
  const QByteArray other = bytesOfFile("room.boxprobe.json");
  leave(R"({"original": "room.boxprobe.json", "name": "<h1>x</h1><img src='/path/a.png' width=300>"})");
  const auto question = answerMessageBox(QString("Recover"));
  offerRecovery(*window_);
  EXPECT_TRUE(question->text.contains("<h1>x</h1>")) << "as it is: " << question->text.toStdString();
  EXPECT_TRUE(question->plain);
  EXPECT_EQ(probe().box.max.x, 5.0);
  EXPECT_EQ(document().path(), "");
  const auto dialog = answerFileDialog(folder_.filePath("saved.boxprobe.json"));
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(dialog->text, "Save as") << "asked where to";
  EXPECT_EQ(bytesOfFile(folder_.filePath("room.boxprobe.json")), other);
  EXPECT_TRUE(QFile::exists(folder_.filePath("saved.boxprobe.json")));
  QDir::setCurrent(before);
}

TEST_F(LeftBehindTest, AnOriginalThatIsAnotherFileByNowIsWrittenOnlyWhenAsked) {
  const QString original = folder_.filePath("mine.boxprobe.json");
  QFile::copy(QString(BOXPROBE_DATA_DIR) + "/scenes/room.glb", folder_.filePath("room.glb"));
  Scene scene = loadSceneFile(roomPath().toStdString());
  scene.models.front().file = folder_.filePath("room.glb").toStdString();
  saveSceneFile(scene, original.toStdString());
  const std::string digest = fileDigest(original.toStdString());
  const auto recover = [&](const std::string& known) {
    leave(QString(R"({"original": "%1", "originalDigest": "%2", "name": "mine", "folder": ""})")
              .arg(original, QString::fromStdString(known))
              .toUtf8());
    const auto question = answerMessageBox(QString("Recover"));
    offerRecovery(*window_);
  };
  recover("00");
  QByteArray before = bytesOfFile(original);
  const auto refused = answerMessageBox(QMessageBox::No);
  EXPECT_FALSE(window_->files().save());
  EXPECT_TRUE(refused->text.contains(original)) << refused->text.toStdString();
  EXPECT_EQ(bytesOfFile(original), before);
  document().markSaved(original.toStdString());  // no question about leaving it

  recover(digest);
  EXPECT_TRUE(window_->files().save()) << "it is the file that was opened";
  EXPECT_EQ(loadSceneFile(original.toStdString()).probes.front().box.max.x, 5.0);

  // Written by somebody else behind the window's back, with the same size and time.
  QByteArray mine = bytesOfFile(original);
  const QDateTime time = QFileInfo(original).lastModified();
  QFile file(original);
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  file.write(mine.replace("room", "ROOM"));
  file.setFileTime(time, QFileDevice::FileModificationTime);
  file.close();
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x = 6.0; });
  const auto asked = answerMessageBox(QMessageBox::No);
  EXPECT_FALSE(window_->files().save());
  EXPECT_TRUE(asked->text.contains("changed on disk")) << asked->text.toStdString();
  EXPECT_EQ(bytesOfFile(original), mine);
  document().markSaved(original.toStdString());
}

TEST_F(RecoveryTest, TheTitleAndTheQuestionSayWhichFolder) {
  const QString folder = QDir::toNativeSeparators(QFileInfo(QString::fromStdString(buildingPath())).path());
  EXPECT_EQ(window_->windowTitle(), "building.boxprobe.json[*] - " + folder + " - Boxprobe");
  edit(2.5);
  const auto question = answerMessageBox(QMessageBox::Cancel);
  EXPECT_FALSE(window_->files().confirmLeaving());
  EXPECT_TRUE(question->text.contains("building.boxprobe.json in " + folder)) << question->text.toStdString();
  EXPECT_TRUE(question->plain);
}

TEST_F(RecoveryTest, AnEarlierRecoveredFileIsNotWrittenOver) {
  const QTemporaryDir folder;
  document().markSaved(folder.filePath("mine.boxprobe.json").toStdString());
  edit(2.5);
  const std::string first = window_->files().saveRecovery();
  const std::string second = window_->files().saveRecovery();
  EXPECT_EQ(first, folder.filePath("mine.recovered.boxprobe.json").toStdString());
  EXPECT_EQ(second, folder.filePath("mine.recovered-2.boxprobe.json").toStdString());
}

// A value that QSettings cannot read throws; a line that is none is an error of the format.
TEST_F(RecoveryTest, ASettingsFileThatCannotBeReadIsKeptAside) {
  keepTheme(2);
  ASSERT_EQ(chosenTheme(), 2);
  const QString path = settingsPath("preferences.ini");
  QFile::remove(path + ".unreadable");
  QFile::rename(path, path + ".good");
  const QByteArray broken = "[General]\nwindowDocks=@Variant(\\0\\0\\0\\t\\x7f\\xff\\xff\\xff)\n";
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(broken);
  file.close();
  EXPECT_TRUE(windowLayout().docks.isEmpty());
  EXPECT_EQ(chosenTheme(), std::nullopt);
  const QStringList remarks = takeSettingsRemarks();
  ASSERT_EQ(remarks.size(), 1);
  EXPECT_TRUE(remarks[0].contains(path) && remarks[0].contains("preferences.ini.unreadable"))
      << remarks[0].toStdString();
  EXPECT_EQ(bytesOfFile(path + ".unreadable"), broken);
  keepTheme(1);
  EXPECT_EQ(chosenTheme(), 1) << "settings start anew";
  EXPECT_TRUE(takeSettingsRemarks().isEmpty());
  QFile::remove(path);
  QFile::remove(path + ".unreadable");
  QFile::rename(path + ".good", path);
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
