// Baking from the window: every field of a capture edits what it says, the buttons make what they say, the state tells
// it, and what was saved is found again.
#include "app/gui/panels/bake_panel.h"

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "app/gui/panels/hides_list.h"
#include "app/gui/panels/outliner.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/widgets/recent_files.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "app/gui/window/file_commands.h"
#include "app/session/time_left.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class BakePanelTest : public WindowTest {
 protected:
  template <typename Widget>
  Widget* named(const char* name) const {
    auto* widget = window_->findChild<Widget*>(name);
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  BakePanel* panel() const { return window_->findChild<BakePanel*>(); }
  QString state() const { return named<QLabel>("bakeState")->text(); }
  /// Chooses as a user does: by the keyboard, with the list open.
  void choose(const char* name, int value) {
    auto* combo = named<QComboBox>(name);
    combo->setFocus();
    combo->showPopup();
    QTest::qWait(20);
    combo->view()->setCurrentIndex(combo->model()->index(combo->findData(value), 0));
    QTest::keyClick(combo->view(), Qt::Key_Return);
  }
  void click(const char* button) { QTest::mouseClick(named<QToolButton>(button), Qt::LeftButton); }
  std::size_t steps() {
    std::size_t count = 0;
    while (document().canUndo()) {
      document().undo();
      ++count;
    }
    return count;
  }
  /// A scene in a folder of its own, open.
  QString openCopy() {
    const QString path = folder_.filePath("copy.boxprobe.json");
    saveSceneFile(document().scene(), path.toStdString());
    EXPECT_TRUE(window_->files().openPath(path));
    waitUntilIdle();
    return path;
  }
  QString environment(int width, int height) {
    ImageRgbaF image{width, height, {}};
    image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 0.5f);
    const QString path = folder_.filePath(QString("light%1.exr").arg(width));
    saveExr(path.toStdString(), image);
    return path;
  }

  QTemporaryDir folder_;
};

TEST_F(BakePanelTest, EveryFieldOfACaptureReachesItsPlaceAsOneStep) {
  type(named<ValueField>("near"), "0.25");
  EXPECT_EQ(probe().nearDistance, 0.25);
  type(named<ValueField>("far"), "42");
  EXPECT_EQ(probe().farDistance, 42.0);
  choose("samplesPerPixel", 16);
  EXPECT_EQ(probe().samplesPerPixel, 16);
  choose("filter", static_cast<int>(FilterKind::Gaussian));
  EXPECT_EQ(probe().filter, FilterKind::Gaussian);
  choose("mode", static_cast<int>(ProbeMode::Realtime));
  EXPECT_EQ(probe().mode, ProbeMode::Realtime);
  choose("mode", static_cast<int>(ProbeMode::Baked));
  EXPECT_EQ(probe().mode, ProbeMode::Baked);
  choose("clear", 1);
  EXPECT_TRUE(std::holds_alternative<ClearToNone>(probe().clear));
  EXPECT_FALSE(named<VectorRow>("clearColor")->isVisible());
  choose("clear", 2);
  type(named<VectorRow>("clearColor")->field(1), "0.75");
  EXPECT_EQ(std::get<glm::vec3>(probe().clear), glm::vec3(0.0f, 0.75f, 0.0f));
  EXPECT_EQ(steps(), 9u);
  waitUntilIdle();
}

TEST_F(BakePanelTest, NearCannotPassFar) {
  type(named<ValueField>("far"), "10");
  type(named<ValueField>("near"), "99");
  EXPECT_LT(probe().nearDistance, 10.0);
  waitUntilIdle();
}

TEST_F(BakePanelTest, AnObjectTickedInTheListIsHiddenFromTheProbe) {
  auto* hides = named<HidesList>("hides");
  const std::uint64_t before = counters().facesCaptured;
  std::string node;
  QTimer::singleShot(0, [&] {
    auto* box = hides->menu()->findChild<QCheckBox*>();
    ASSERT_NE(box, nullptr);
    node = box->objectName().toStdString();
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    hides->menu()->close();
  });
  QTest::mouseClick(hides, Qt::LeftButton);
  ASSERT_FALSE(node.empty());
  ASSERT_EQ(probe().hides, std::vector<std::string>{node});
  EXPECT_TRUE(hides->text().contains(QString::fromStdString(node)));
  waitUntilIdle();
  EXPECT_GT(counters().facesCaptured, before);
  document().undo();
  EXPECT_TRUE(probe().hides.empty());
  waitUntilIdle();
}

TEST_F(BakePanelTest, BakeMakesTheProbeAgainAndTheStateFollows) {
  EXPECT_EQ(state(), "Up to date");
  QStringList seen;
  const auto connection =
      QObject::connect(panel(), &BakePanel::statesChanged, [&seen](const auto& looks) { seen << looks.front().text; });
  const std::uint64_t before = counters().facesCaptured;
  click("bake");
  EXPECT_NE(state(), "Up to date");
  waitUntilIdle();
  QObject::disconnect(connection);
  EXPECT_EQ(counters().facesCaptured - before, 6u);
  EXPECT_EQ(state(), "Up to date");
  EXPECT_TRUE(seen.contains("Capturing")) << seen.join(", ").toStdString();
  EXPECT_EQ(window_->findChild<Outliner*>()->model().probe(0).data(Qt::ToolTipRole), "Up to date");
  EXPECT_FALSE(document().canUndo()) << "baking edits nothing";
}

TEST_F(BakePanelTest, BakeAllMakesEveryProbe) {
  QTest::mouseClick(named<QToolButton>("Duplicate"), Qt::LeftButton);
  // At the same place the two would share their maps.
  window_->editor().commitProbe("Move", [](Probe& edited) { edited.origin.x += 0.5; });
  waitUntilIdle();
  const std::uint64_t before = counters().facesCaptured;
  click("bakeAll");
  waitUntilIdle();
  EXPECT_EQ(counters().facesCaptured - before, 12u);
}

TEST_F(BakePanelTest, StopLeavesTheRestAndTheStateSaysSo) {
  click("bake");
  ASSERT_TRUE(waitFor([this] { return state() == "Capturing"; })) << state().toStdString();
  click("stopBake");
  waitUntilIdle();
  EXPECT_TRUE(window_->renderer().workPending());
  EXPECT_EQ(state(), "Out of date: capturing was stopped");
  EXPECT_FALSE(named<QToolButton>("stopBake")->isEnabled());
  window_->scheduler().resumeWork();
  waitUntilIdle();
  EXPECT_EQ(state(), "Up to date");
}

TEST_F(BakePanelTest, WhatIsSavedBesideTheSceneIsLoadedWithIt) {
  const QString path = openCopy();
  const auto question = answerMessageBox(QMessageBox::Save);
  click("saveBaked");
  EXPECT_TRUE(question->text.contains("copy.probes")) << question->text.toStdString();
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_->statusBar()->currentMessage().startsWith("Wrote"); }, 120000));
  const QDir files(folder_.filePath("copy.probes"));
  EXPECT_TRUE(files.exists("room.exr"));
  // As a program started again: this window's own maps are kept for undo.
  MainWindow second;
  second.resize(window_->size());
  second.showScene(loadScene(path.toStdString()));
  second.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&second, 60000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return second.scheduler().idle() && !second.renderer().workPending(); }, 300000));
  EXPECT_EQ(second.renderer().counters().facesCaptured, 0u);
  EXPECT_EQ(second.findChild<QLabel*>("bakeState")->text(), "Loaded from disk, up to date");
}

// By the menu: the button is off meanwhile.
TEST_F(BakePanelTest, WhileFilesAreSavedAFurtherSaveDoesNothing) {
  openCopy();
  QAction* save = nullptr;
  for (QAction* action : window_->menuBar()->findChildren<QAction*>()) {
    if (action->text().remove('&') == "Save baked probes...") save = action;
  }
  ASSERT_NE(save, nullptr);
  const auto question = answerMessageBox(QMessageBox::Save);
  save->trigger();
  EXPECT_FALSE(question->text.isEmpty());
  ASSERT_FALSE(named<QToolButton>("saveBaked")->isEnabled()) << "saved already; a level at a time it is not";
  bool asked = false;
  QTimer::singleShot(0, window_, [&asked] {
    if (QWidget* modal = QApplication::activeModalWidget()) {
      asked = true;
      modal->close();
    }
  });
  save->trigger();
  EXPECT_FALSE(asked);
  EXPECT_TRUE(QTest::qWaitFor([this] { return window_->statusBar()->currentMessage().startsWith("Wrote"); }, 120000));
}

TEST_F(BakePanelTest, BakingIsNotToldAsStaleFiles) {
  const QString path = folder_.filePath("copy.boxprobe.json");
  saveSceneFile(document().scene(), path.toStdString());
  ASSERT_TRUE(QDir(folder_.path()).mkpath("copy.probes"));
  ImageRgbaF image{4, 2, std::vector<float>(32, 0.5f)};
  saveExr(folder_.filePath("copy.probes/other.exr").toStdString(), image);
  ASSERT_TRUE(window_->files().openPath(path));
  QStringList told;
  const auto connection =
      QObject::connect(panel(), &BakePanel::message, [&told](const QString& text) { told << text; });
  click("bake");
  waitUntilIdle();
  QObject::disconnect(connection);
  EXPECT_EQ(state(), "Up to date");
  EXPECT_TRUE(told.filter("missing or out of date").isEmpty()) << told.join("; ").toStdString();
}

TEST_F(BakePanelTest, ACustomProbeTakesItsImageFromTheDialogAndRefusesWhatIsNone) {
  answerFileDialog(environment(64, 32));
  choose("mode", static_cast<int>(ProbeMode::Custom));
  ASSERT_EQ(probe().mode, ProbeMode::Custom);
  EXPECT_TRUE(QString::fromStdString(probe().image).endsWith("light64.exr"));
  EXPECT_FALSE(named<ValueField>("near")->isVisible()) << "an image is not captured";
  waitUntilIdle();
  EXPECT_EQ(state(), "Custom image light64.exr");
  document().undo();
  EXPECT_EQ(probe().mode, ProbeMode::Baked);

  QFile bad(folder_.filePath("bad.exr"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("not a picture");
  bad.close();
  answerFileDialog(bad.fileName());
  std::shared_ptr<SeenDialog> box;
  QTimer::singleShot(200, [&] { box = answerMessageBox(QMessageBox::Ok); });
  choose("mode", static_cast<int>(ProbeMode::Custom));
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text.contains("bad.exr")) << box->text.toStdString();
  EXPECT_FALSE(box->text.contains('\n'));
  EXPECT_EQ(probe().mode, ProbeMode::Baked);
  EXPECT_EQ(named<QComboBox>("mode")->currentData().toInt(), static_cast<int>(ProbeMode::Baked));
  waitUntilIdle();
}

TEST_F(BakePanelTest, AnEncodedImageTakesItsEncodingAndDecodeInstruction) {
  ImageRgba8 map;
  map.width = 64;
  map.height = 32;
  map.pixels.assign(std::size_t(4) * 64 * 32, 128);
  const QString path = folder_.filePath("coded.png");
  savePng(path.toStdString(), map);
  answerFileDialog(path);
  choose("mode", static_cast<int>(ProbeMode::Custom));
  ASSERT_EQ(probe().mode, ProbeMode::Custom);
  EXPECT_EQ(probe().encoding, ImageEncoding::Rgbm) << "what a PNG of radiance usually is";
  EXPECT_FALSE(probe().decode);
  EXPECT_TRUE(named<ValueField>("decodeMultiplier")->isVisible());
  EXPECT_NEAR(named<ValueField>("decodeMultiplier")->value(), 34.4932, 1e-4);
  type(named<ValueField>("decodeExponent"), "1");
  EXPECT_EQ(probe().decode, glm::dvec2(34.493242, 1.0));
  choose("encoding", static_cast<int>(ImageEncoding::Dldr));
  EXPECT_EQ(probe().encoding, ImageEncoding::Dldr);
  EXPECT_FALSE(probe().decode) << "the instruction was RGBM's";
  EXPECT_FALSE(named<ValueField>("decodeExponent")->isVisible());
  waitUntilIdle();
  EXPECT_EQ(state(), "Custom image coded.png");
  answerFileDialog(environment(64, 32));
  click("chooseImage");
  EXPECT_EQ(probe().encoding, ImageEncoding::Linear) << "an .exr has none";
  EXPECT_FALSE(named<ValueField>("decodeMultiplier")->isVisible());
  EXPECT_EQ(steps(), 4u);
  waitUntilIdle();
}

TEST_F(BakePanelTest, OpenedFilesLeadTheRecentOnesAndOpenAgain) {
  const QString path = openCopy();
  ASSERT_FALSE(recentFiles().isEmpty());
  EXPECT_EQ(recentFiles().front(), path);
  QMenu* recent = nullptr;
  for (QMenu* menu : window_->menuBar()->findChildren<QMenu*>()) {
    if (menu->title() == "Open &recent") recent = menu;
  }
  ASSERT_NE(recent, nullptr);
  ASSERT_FALSE(recent->actions().isEmpty());
  window_->showScene(smallBuilding());
  recent->actions().front()->trigger();
  QCoreApplication::processEvents();
  EXPECT_EQ(document().path(), path.toStdString());
  waitUntilIdle();
}

TEST(TimeLeft, IsWhatIsLeftAtTheSpeedSoFar) {
  TimeLeft left;
  EXPECT_FALSE(left.update(0.0, 10.0));
  EXPECT_FALSE(left.update(0.1, 10.5)) << "too early to judge";
  const auto seconds = left.update(0.25, 15.0);
  ASSERT_TRUE(seconds);
  EXPECT_NEAR(*seconds, 15.0, 1e-9);
  EXPECT_FALSE(left.update(0.1, 16.0)) << "work was added: the old speed says nothing";
  EXPECT_EQ(TimeLeft::text(12.3).english(), "12 s left");
  EXPECT_EQ(TimeLeft::text(240.0).english(), "4 min left");
}

}  // namespace
}  // namespace boxprobe
