// What a technical artist does with a model of their own, from the drop to the file, with nothing but gestures: once
// whole, through a killed process, and once counted.
#include <gtest/gtest.h>
#include <signal.h>

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QProcess>
#include <QProcessEnvironment>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/panels/fit_panel.h"
#include "app/gui/panels/place_panel.h"
#include "app/gui/view/view_comparison.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/autosave.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/recovery.h"
#include "app/gui/window/view_tools.h"
#include "data/scenes/glb_writer.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/window_test.h"
#include "tests/support/made_flat.h"

namespace boxprobe {
namespace {

constexpr int kSteps = 30;

class GesturesTest : public WindowTest {
 protected:
  void SetUp() override {
    for (const Autosave::Kept& kept : Autosave::leftBehind()) Autosave::discard(kept);
    WindowTest::SetUp();
  }
  void TearDown() override { window_->probeWidget().setMode(HandleMode::Box); }

  // Each of these is one gesture.
  void drop(const QString& path) {
    ++gestures_;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_, &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_, &event);
    waitUntilIdle();
  }
  void chord(Qt::Key pressed, Qt::KeyboardModifiers modifiers = {}) {
    ++gestures_;
    window_->viewport().setFocus();
    key(pressed, modifiers);
  }
  void click(const char* name) {
    ++gestures_;
    auto* button = window_->findChild<QPushButton*>(name);
    ASSERT_NE(button, nullptr) << name;
    ASSERT_TRUE(button->isVisible() && button->isEnabled()) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }
  /// From outside, where all handles are in view: F stays indoors.
  void lookDownAt(const glm::dvec3& point) {
    auto& renderer = const_cast<SceneRenderer&>(window_->renderer());
    Camera camera = renderer.currentCamera();
    camera.target = point;
    camera.position = point + glm::dvec3(4.0, 8.0, 6.0);
    camera.up = {0.0, 1.0, 0.0};
    renderer.applyCamera(camera);
    emit window_->viewport().cameraMoved();
    waitUntilIdle();
  }
  void pull(const Handle& handle, double metres, std::size_t grip = 1) {
    ++gestures_;
    const auto points = handleGripWorld(probe(handle.probe), handle, window_->viewport().view());
    const glm::dvec3 from = points[std::min(grip, points.size() - 1)];
    drag(pixelOf(from), pixelOf(from + metres * handleAxisWorld(probe(handle.probe), handle)));
  }
  void menu(const QString& text) {
    ++gestures_;
    for (QMenu* each : window_->menuBar()->findChildren<QMenu*>()) {
      for (QAction* action : each->actions()) {
        if (QString(action->text()).remove('&') == text) return action->trigger();
      }
    }
    FAIL() << "no menu has " << text.toStdString();
  }

  QString writeFlat(const QString& folder, double unitsPerMetre, double yawDegrees, double groundMetres) {
    test::FlatWishes wishes;
    wishes.unitsPerMetre = unitsPerMetre;
    wishes.yawDegrees = yawDegrees;
    wishes.groundMetres = groundMetres;
    QFile file(QDir(folder).filePath("flat.glb"));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    Model model = test::madeFlat(wishes);
    // White metal loses no light: whatever the probes, its pictures would be the same.
    Material& paint = model.materials.front();
    paint.baseColor = {0.6f, 0.55f, 0.5f, 1.0f};
    paint.metallic = 0.0f;
    paint.roughness = 0.8f;
    const std::string bytes = scenes::glbBytes(model);
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    return file.fileName();
  }
  void placeAndApply() {
    auto* panel = window_->findChild<PlacePanel*>();
    panel->setPaths(8);
    chord(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    const auto* apply = window_->findChild<QPushButton*>("applyPlaced");
    ASSERT_TRUE(waitFor([&] { return !panel->running() && apply->isVisible(); }));
    click("applyPlaced");
    ASSERT_EQ(document().scene().probes.size(), 2u);
  }
  /// A fit under way is waited for, and taken where it proposes something.
  void endFit() {
    auto* panel = window_->findChild<FitPanel*>();
    ASSERT_TRUE(waitFor([&] { return !panel->running(); }));
    const auto* apply = window_->findChild<QPushButton*>("applyFit");
    if (apply->isVisible() && apply->isEnabled()) click("applyFit");
  }

  int gestures_ = 0;
};

// Of another process, which AllGesturesOutliveAKilledProcessAndReadBackEqual starts: ends with kill -9.
TEST_F(GesturesTest, DISABLED_EditsAFlatAndIsKilled) {
  const QString folder = qEnvironmentVariable("BOXPROBE_TEST_GESTURES");
  ASSERT_FALSE(folder.isEmpty());
  drop(writeFlat(folder, 1.0, 0.0, 0.0));
  ASSERT_TRUE(QString::fromStdString(document().scene().models.front().file).endsWith("flat.glb"));
  placeAndApply();
  chord(Qt::Key_F, Qt::ControlModifier);
  endFit();
  chord(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  endFit();
  ASSERT_EQ(document().scene().probes.size(), 3u);
  const std::size_t added = *document().selectedProbe();
  // All at once: small enough to wait for.
  chord(Qt::Key_A, Qt::ControlModifier);
  auto* faceSize = window_->findChild<QComboBox*>("faceSize");
  faceSize->setFocus();
  while (faceSize->currentData().toInt() > 32) key(Qt::Key_Up);
  for (const Probe& each : document().scene().probes) ASSERT_EQ(each.faceSize, 32);
  window_->editor().selectProbe(added);
  waitUntilIdle();

  // Moved, turned, its influence set.
  chord(Qt::Key_4);
  const glm::dvec3 middle = probe(added).box.center();
  lookDownAt(middle);
  const double far = 0.2 * probe(added).box.size().x;
  pull({HandleKind::Move, added, {0, true}}, far);
  EXPECT_NEAR(glm::length(probe(added).box.center() - middle), far, 0.2 * far);
  const glm::dvec3 now = probe(added).box.center();
  window_->tools().views().lookAtSpot(now, now + glm::dvec3(4.0, 8.0, 6.0));
  waitUntilIdle();
  const auto ring = handleGripWorld(probe(added), {HandleKind::Turn, added, {1, true}}, window_->viewport().view());
  const double yaw = probe(added).rotationDegrees.y;
  // Taken where no arrow and no diamond is nearer.
  const auto takes = [&](std::size_t i) {
    const QPointF pixel = pixelOf(ring[i]);
    const auto under = handleAt(document().scene().probes, added, window_->viewport().view(), {pixel.x(), pixel.y()},
                                12.0, HandleMode::Place);
    return under && under->kind == HandleKind::Turn && under->face.axis == 1;
  };
  std::size_t first = 0;
  while (first < 40 && !takes(first)) ++first;
  ASSERT_LT(first, 40u);
  press(pixelOf(ring[first]));
  for (std::size_t i = first + 1; i <= first + 3; ++i) move(pixelOf(ring[i]));
  release(pixelOf(ring[first + 3]));
  EXPECT_NE(probe(added).rotationDegrees.y, yaw);
  chord(Qt::Key_2);
  lookDownAt(probe(added).box.center());
  pull({HandleKind::Influence, added, {0, true}}, -far, 0);
  EXPECT_TRUE(probe(added).influence);

  // Compared, which edits nothing.
  const std::size_t steps = document().stepLabels().size();
  chord(Qt::Key_C, Qt::AltModifier);
  ASSERT_TRUE(waitFor([this] { return !window_->tools().sideBySide().making(); }));
  chord(Qt::Key_Escape);
  chord(Qt::Key_C);
  chord(Qt::Key_Escape);
  EXPECT_EQ(document().stepLabels().size(), steps);
  chord(Qt::Key_F5);
  waitUntilIdle();

  const auto dialog = answerFileDialog(QDir(folder).filePath("flat.boxprobe.json"));
  chord(Qt::Key_S, Qt::ControlModifier);
  ASSERT_FALSE(window_->isWindowModified());
  ASSERT_TRUE(loadSceneFile(document().path()) == document().scene());

  // Thirty steps in all and some more, all taken back and done again.
  chord(Qt::Key_3);
  move({3, 3});
  while (static_cast<int>(document().position()) < kSteps + 2) chord(Qt::Key_PageUp, Qt::ShiftModifier);
  std::vector<Scene> scenes = {document().scene()};
  for (int i = 0; i < kSteps; ++i) {
    chord(Qt::Key_Z, Qt::ControlModifier);
    scenes.push_back(document().scene());
    ASSERT_FALSE(scenes[scenes.size() - 2] == scenes.back()) << "undo " << i;
  }
  for (int i = kSteps - 1; i >= 0; --i) {
    chord(Qt::Key_Y, Qt::ControlModifier);
    ASSERT_TRUE(document().scene() == scenes[static_cast<std::size_t>(i)]) << "redo";
  }
  ASSERT_TRUE(window_->autosave().write());
  saveSceneFile(document().scene(), QDir(folder).filePath("expected.boxprobe.json").toStdString());
  std::printf("%d gestures\n", gestures_);
  std::fflush(stdout);
  if (HasFailure()) return;
  raise(SIGKILL);
}

TEST_F(GesturesTest, AllGesturesOutliveAKilledProcessAndReadBackEqual) {
  const QTemporaryDir folder;
  QProcess child;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("BOXPROBE_TEST_PREFERENCES", qEnvironmentVariable("XDG_DATA_HOME"));
  environment.insert("BOXPROBE_TEST_GESTURES", folder.path());
  child.setProcessEnvironment(environment);
  child.start(QCoreApplication::applicationFilePath(),
              {"--gtest_also_run_disabled_tests", "--gtest_filter=GesturesTest.DISABLED_EditsAFlatAndIsKilled"});
  ASSERT_TRUE(child.waitForFinished(600000));
  const std::string output = child.readAllStandardOutput().toStdString();
  ASSERT_EQ(child.exitStatus(), QProcess::CrashExit) << output;
  std::printf("%s", output.substr(output.rfind('\n', output.size() - 2) + 1).c_str());
  const Scene expected = loadSceneFile(folder.filePath("expected.boxprobe.json").toStdString());

  ASSERT_EQ(Autosave::leftBehind().size(), 1u);
  const auto question = answerMessageBox(QString("Recover"));
  offerRecovery(*window_);
  EXPECT_TRUE(question->text.contains("flat.boxprobe.json")) << question->text.toStdString();
  EXPECT_TRUE(document().scene() == expected);
  EXPECT_TRUE(window_->isWindowModified());
  const std::string path = folder.filePath("flat.boxprobe.json").toStdString();
  EXPECT_EQ(document().path(), path);
  EXPECT_FALSE(loadSceneFile(path) == expected) << "the file itself waits for the user";
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(window_->isWindowModified());
  window_->showScene(smallBuilding());
  ASSERT_TRUE(window_->files().openPath(QString::fromStdString(path)));
  EXPECT_TRUE(document().scene() == expected);
  waitUntilIdle();
}

TEST_F(GesturesTest, AFlatInCentimetresTurnedBy25DegreesGetsTwoBakedAndSavedProbesInSevenGestures) {
  const QTemporaryDir folder;
  const QString flat = writeFlat(folder.path(), 100.0, 25.0, 80.0);
  QElapsedTimer time;
  time.start();
  drop(flat);
  placeAndApply();
  waitUntilIdle();  // both are captured
  for (const Probe& placed : document().scene().probes) {
    EXPECT_NEAR(std::remainder(placed.rotationDegrees.y - 25.0, 90.0), 0.0, 0.5) << placed.name;
    EXPECT_NEAR(placed.box.size().y, 260.0, 3.0) << placed.name;
  }
  // The command, the name and the answer are a gesture each.
  gestures_ += 2;
  const auto dialog = answerFileDialog(folder.filePath("flat.boxprobe.json"));
  chord(Qt::Key_S, Qt::ControlModifier);
  const auto question = answerMessageBox(QMessageBox::Save);
  menu("Save baked probes...");
  EXPECT_TRUE(question->text.contains("flat.probes")) << question->text.toStdString();
  ASSERT_TRUE(waitFor([this] { return window_->statusBar()->currentMessage().startsWith("Wrote"); }));
  const double seconds = 1e-3 * static_cast<double>(time.elapsed());
  std::printf("From the drop to two baked and saved probes: %d gestures, %.1f s\n", gestures_, seconds);
  EXPECT_EQ(gestures_, 7);
  const LoadedScene read = loadScene(folder.filePath("flat.boxprobe.json").toStdString());
  EXPECT_TRUE(read.scene == document().scene());
  const QStringList files = QDir(folder.filePath("flat.probes")).entryList({"*.exr"}, QDir::Files);
  for (const Probe& placed : document().scene().probes) {
    EXPECT_TRUE(files.contains(QString::fromStdString(placed.name) + ".exr")) << files.join(", ").toStdString();
  }
}

}  // namespace
}  // namespace boxprobe
