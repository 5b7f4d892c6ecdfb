// Open, save, drop, close: what is written reads back, and nothing is lost unasked.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUrl>
#include <chrono>
#include <filesystem>

#include "app/gui/view/viewport.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/model_fitter.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class FileTest : public WindowTest {
 protected:
  void edit() {
    window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x = 3.0; });
  }
  void drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_, &enter);
    if (!enter.isAccepted()) return;
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_, &event);
  }
  QString inFolder(const QString& name) const { return folder_.filePath(name); }
  static QString dataFile(const char* name) { return QString(BOXPROBE_DATA_DIR) + "/scenes/" + name; }

  QTemporaryDir folder_;
};

TEST_F(FileTest, SaveAsWritesWhatReadsBackAndTheTitleFollows) {
  EXPECT_TRUE(window_->windowTitle().startsWith("building.boxprobe.json"));
  // What --set changed counts as opened, not as edited.
  EXPECT_FALSE(window_->isWindowModified());
  edit();
  EXPECT_TRUE(window_->isWindowModified());
  const auto dialog = answerFileDialog(inFolder("mine"));
  key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(dialog->text, "Save as");
  const QString path = inFolder("mine.boxprobe.json");
  ASSERT_TRUE(QFile::exists(path));
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_TRUE(window_->windowTitle().startsWith("mine.boxprobe.json"));
  const LoadedScene read = loadScene(path.toStdString());
  EXPECT_TRUE(read.scene.probes == document().scene().probes);
  EXPECT_EQ(read.models.size(), 1u) << "the model's path must be found from the new folder";

  document().undo();
  EXPECT_TRUE(window_->isWindowModified());
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_EQ(loadScene(path.toStdString()).scene.probes.front().box.max.x, 1.5);
}

TEST_F(FileTest, AFailedSaveKeepsTheStar) {
  edit();
  document().markSaved("/nowhere/at/all.boxprobe.json");
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x = 2.0; });
  const auto box = answerMessageBox(QMessageBox::Ok);
  EXPECT_FALSE(window_->files().save());
  EXPECT_TRUE(box->text.contains("/nowhere/at/all.boxprobe.json"));
  EXPECT_TRUE(window_->isWindowModified());
}

TEST_F(FileTest, AnEndThatDoesNotAskWritesUnsavedChangesBesideTheFile) {
  EXPECT_EQ(window_->files().saveRecovery(), "") << "nothing is unsaved";
  document().markSaved(inFolder("mine.boxprobe.json").toStdString());
  edit();
  const std::string path = window_->files().saveRecovery();
  EXPECT_EQ(path, inFolder("mine.recovered.boxprobe.json").toStdString());
  EXPECT_EQ(loadScene(path).scene.probes.front().box.max.x, 3.0);
  EXPECT_FALSE(QFile::exists(inFolder("mine.boxprobe.json"))) << "the user's own file is the user's to save";
  EXPECT_TRUE(window_->isWindowModified());

  const QTemporaryDir home;
  const QByteArray usual = qgetenv("XDG_DATA_HOME");
  qputenv("XDG_DATA_HOME", home.path().toUtf8());
  document().markSaved("/nowhere/at/all.boxprobe.json");
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x = 2.0; });
  const std::string elsewhere = window_->files().saveRecovery();
  qputenv("XDG_DATA_HOME", usual);
  EXPECT_EQ(elsewhere.rfind(home.path().toStdString(), 0), 0u) << elsewhere;
  EXPECT_EQ(loadScene(elsewhere).scene.probes.front().box.max.x, 2.0);
}

TEST_F(FileTest, ADroppedSceneOpens) {
  drop(dataFile("room.boxprobe.json"));
  EXPECT_TRUE(window_->windowTitle().startsWith("room.boxprobe.json"));
  EXPECT_EQ(probe().box.max.x, 4.0);
  EXPECT_FALSE(document().canUndo());
  waitUntilIdle();
}

TEST_F(FileTest, ADroppedModelIsTreatedByWhatItIsUntilTheUserSaysOtherwise) {
  drop(dataFile("room.glb"));
  ASSERT_EQ(document().scene().probes.size(), 1u);
  EXPECT_EQ(probe().name, "probe");
  EXPECT_NEAR(probe().box.max.x, 4.0, 0.1);
  EXPECT_TRUE(window_->windowTitle().contains("not saved"));
  auto* kind = window_->findChild<QToolButton*>("modelKind");
  ASSERT_NE(kind, nullptr);
  EXPECT_FALSE(kind->isHidden());
  EXPECT_EQ(kind->text(), "Interior");
  waitUntilIdle();
  EXPECT_TRUE(waitFor([this] { return document().scene().exposure != 1.0; })) << "found from the first picture";
  EXPECT_FALSE(window_->isWindowModified()) << "and part of opening it";

  window_->modelFitter().treatAs(ModelKind::Object);
  EXPECT_TRUE(document().scene().probes.empty());
  EXPECT_EQ(document().scene().exposure, 1.0);
  EXPECT_EQ(kind->text(), "Object");
  EXPECT_EQ(document().undoLabel(), "Treat as object");
  window_->modelFitter().lightBy(FitLight::Daylight);
  EXPECT_EQ(document().scene().lights.size(), 1u);
  window_->editor().undo();
  window_->editor().undo();
  EXPECT_EQ(document().scene().probes.size(), 1u);
  drop(dataFile("room.boxprobe.json"));
  EXPECT_TRUE(kind->isHidden());
}

TEST_F(FileTest, OtherFilesAreNotTaken) {
  drop(QString(BOXPROBE_SOURCE_DIR) + "/CMakeLists.txt");
  EXPECT_TRUE(window_->windowTitle().startsWith("building.boxprobe.json"));
}

TEST_F(FileTest, OpeningOverChangesAsksFirst) {
  edit();
  const auto cancelled = answerMessageBox(QMessageBox::Cancel);
  EXPECT_FALSE(window_->files().openPath(dataFile("room.boxprobe.json")));
  EXPECT_TRUE(cancelled->text.contains("building.boxprobe.json"));
  EXPECT_EQ(probe().box.max.x, 3.0);
  answerMessageBox(QMessageBox::Discard);
  EXPECT_TRUE(window_->files().openPath(dataFile("room.boxprobe.json")));
  EXPECT_EQ(probe().box.max.x, 4.0);
}

TEST_F(FileTest, AFileThatCannotBeReadLeavesTheSceneAndSaysWhyInOneLine) {
  QFile file(inFolder("bad.boxprobe.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"format\": \"boxprobe-scene\", \"version\": 1, \"colour\": 3}");
  file.close();
  const auto box = answerMessageBox(QMessageBox::Ok);
  EXPECT_FALSE(window_->files().openPath(file.fileName()));
  EXPECT_TRUE(box->text.contains("bad.boxprobe.json")) << box->text.toStdString();
  EXPECT_TRUE(box->text.contains("colour")) << box->text.toStdString();
  EXPECT_FALSE(box->text.contains('\n'));
  EXPECT_EQ(probe().name, "room");
  EXPECT_EQ(document().scene().models.size(), 1u);
}

TEST_F(FileTest, ASkyThatCannotBeReadLeavesTheScene) {
  QFile sky(inFolder("sky.hdr"));
  ASSERT_TRUE(sky.open(QIODevice::WriteOnly));
  sky.write("not a picture");
  sky.close();
  QFile file(inFolder("sky.boxprobe.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"format\": \"boxprobe-scene\", \"version\": 1, \"sky\": {\"image\": \"sky.hdr\"}}");
  file.close();
  const auto box = answerMessageBox(QMessageBox::Ok);
  EXPECT_FALSE(window_->files().openPath(file.fileName()));
  EXPECT_TRUE(box->text.contains("sky.hdr")) << box->text.toStdString();
  EXPECT_EQ(document().scene().models.size(), 1u);
}

TEST_F(FileTest, ClosingWithChangesAsks) {
  edit();
  answerMessageBox(QMessageBox::Cancel);
  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(window_->isVisible());
  answerMessageBox(QMessageBox::Discard);
  EXPECT_TRUE(window_->close());
}

TEST_F(FileTest, ClosingWithoutChangesDoesNotAsk) {
  EXPECT_TRUE(window_->close());
}

TEST_F(FileTest, ADroppedPictureIsTheSkyAndABrokenOneChangesNothing) {
  ImageRgbaF picture{8, 4, std::vector<float>(8 * 4 * 4, 0.5F)};
  const QString good = inFolder("sky.exr"), bad = inFolder("bad.hdr");
  saveExr(good.toStdString(), picture);
  QFile file(bad);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is none");
  file.close();
  const Scene before = document().scene();
  const auto seen = answerMessageBox(QMessageBox::Ok);
  drop(bad);
  EXPECT_FALSE(seen->text.isEmpty());
  EXPECT_TRUE(document().scene() == before);
  drop(good);
  const auto* sky = std::get_if<SkyImage>(&document().scene().sky);
  ASSERT_NE(sky, nullptr);
  EXPECT_EQ(QString::fromStdString(sky->file), QFileInfo(good).absoluteFilePath());
  EXPECT_EQ(document().undoLabel(), "Sky from sky.exr");
  document().undo();
  EXPECT_TRUE(document().scene() == before);
}

TEST_F(FileTest, KeysAreForThePictureOnceASceneIsOpened) {
  const QString path = inFolder("other.boxprobe.json");
  saveSceneFile(scene().scene, path.toStdString());
  window_->findChild<QLineEdit*>("outlinerFilter")->setFocus();
  ASSERT_TRUE(window_->files().openPath(path));
  EXPECT_EQ(QApplication::focusWidget(), &window_->viewport());
}

TEST_F(FileTest, AFileThatChangesOnDiskIsReadAgainUnlessThereAreChanges) {
  const QString path = inFolder("mine.boxprobe.json");
  // The X server may tell only now that the dialog of the test before has lost the focus; see key().
  QCoreApplication::processEvents();
  const auto dialog = answerFileDialog(path);
  key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(QFile::exists(path));
  const auto writeOther = [&](double x) {
    Scene other = loadSceneFile(path.toStdString());
    other.probes.front().box.max.x = x;
    const std::filesystem::path file(path.toStdString());
    const auto before = std::filesystem::last_write_time(file);
    saveSceneFile(other, path.toStdString());
    // Later by more than any file system rounds times to.
    std::filesystem::last_write_time(file, before + std::chrono::seconds(5));
  };
  key(Qt::Key_P);
  const Camera view = window_->renderer().currentCamera();
  auto* typing = window_->findChild<QLineEdit*>("outlinerFilter");
  typing->setFocus();
  writeOther(1.25);
  EXPECT_TRUE(QTest::qWaitFor([this] { return probe().box.max.x == 1.25; }, 120000)) << "read again";
  EXPECT_EQ(QApplication::focusWidget(), typing) << "nobody asked for it";
  window_->viewport().setFocus();
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_NEAR(window_->renderer().currentCamera().position.y, view.position.y, 1e-9) << "the view stays";
  edit();
  writeOther(0.5);
  EXPECT_TRUE(
      QTest::qWaitFor([this] { return window_->statusBar()->currentMessage().contains("changed on disk"); }, 120000));
  EXPECT_EQ(probe().box.max.x, 3.0) << "one's own changes stay";
  document().undo();
}

}  // namespace
}  // namespace boxprobe
