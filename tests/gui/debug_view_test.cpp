// The debug view as its user drives it: the tool, the pointer, a click, colours of surfaces, rays.
#include "app/gui/explain/debug_view.h"

#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/gui/explain/explain_card.h"
#include "app/gui/explain/footprint_view.h"
#include "app/gui/explain/ray_panel.h"
#include "app/gui/explain/schematic_inset.h"
#include "app/gui/explain/surface_view_panel.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class DebugViewTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    shiny_ = pixelOf({0.3, 0.0, -0.6});
  }
  void TearDown() override {
    debug().setTool(false);
    debug().surfacePanel()->choose(0);
    move({3.0, 3.0});
    waitUntilIdle();
  }

  DebugView& debug() { return window_->debugView(); }
  std::uint64_t explanations() { return debug().inspector().explanations(); }
  void startTool() {
    key(Qt::Key_E);
    ASSERT_TRUE(debug().inspector().tool());
    move(shiny_);
    settle();
  }
  /// What the turns of the event loop still have to explain is explained, and drawn.
  void settle() {
    QCoreApplication::processEvents();
    waitUntilIdle();
  }
  template <typename Widget>
  Widget* find(const char* name) {
    Widget* found = window_->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void raise(const char* dock) {
    find<QDockWidget>(dock)->raise();
    QTest::qWait(20);
  }
  void choose(const char* combo, int index) {
    auto* box = find<QComboBox>(combo);
    box->setCurrentIndex(index);
    emit box->activated(index);
    waitUntilIdle();
  }
  /// For a look at it: kept where BOXPROBE_TEST_OUTPUT says.
  void keep(const QString& name) {
    const QString folder = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
    if (folder.isEmpty()) return;
    QDir().mkpath(folder);
    QTest::qWait(50);
    window_->grab().save(folder + "/" + name + ".png");
  }

  QPointF sky_{305.0, 150.0};
  QPointF shiny_;  ///< a sphere in the probe, off all handles
};

TEST_F(DebugViewTest, OffItExplainsNothingAndDrawsNothing) {
  const std::uint64_t before = explanations(), renders = window_->scheduler().renders();
  for (int i = 0; i < 20; ++i) move(shiny_ + QPointF(3 * i, 0));
  settle();
  EXPECT_EQ(explanations(), before);
  EXPECT_EQ(window_->scheduler().renders(), renders);
  EXPECT_FALSE(debug().rays().visible());
  EXPECT_FALSE(debug().schematic()->isVisible());
  press(shiny_);
  release(shiny_);
  EXPECT_FALSE(debug().inspector().pinned());
}

TEST_F(DebugViewTest, FollowsThePointerOnceATurn) {
  startTool();
  EXPECT_TRUE(debug().card()->isVisible());
  EXPECT_TRUE(debug().schematic()->isVisible());
  EXPECT_TRUE(debug().rays().visible());
  EXPECT_GE(debug().rays().rays(), 4) << "eye ray, normal, reflected ray and lookup";
  const QString first = debug().card()->text();
  EXPECT_TRUE(first.contains("room")) << first.toStdString();
  keep("follow");

  const std::uint64_t before = explanations(), renders = window_->scheduler().renders();
  for (int i = 1; i <= 10; ++i) emit window_->viewport().pointerMoved(shiny_ + QPointF(2 * i, 0));
  settle();
  EXPECT_EQ(explanations(), before + 1) << "ten moves in one turn";
  EXPECT_EQ(window_->scheduler().renders(), renders + 1);
  EXPECT_NE(debug().card()->text(), first);
}

// A face that is off is named by the verdict and put where the ray ends, as one step.
TEST_F(DebugViewTest, TheVerdictsMendMovesTheFace) {
  const Probe room = loadSceneFile(BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json").probes.front();
  window_->editor().commitProbe("As in the scene", [&](Probe& edited) { edited = room; });
  waitUntilIdle();
  key(Qt::Key_E);
  // A point of the floor that reflects a wall, where the box is right.
  nlohmann::json json;
  bool wall = false;
  for (int i = 0; i < 25 && !wall; ++i) {
    const QPointF floor = pixelOf({-1.5 + 0.6 * (i % 5), 0.0, 2.2 - 0.5 * (i / 5)});
    press(floor);
    release(floor);
    waitUntilIdle();
    debug().copyJson();
    json = nlohmann::json::parse(QApplication::clipboard()->text().toStdString());
    if (json["probes"].empty() || json["probes"][0]["trueDistance"].is_null()) continue;
    const auto& seen = json["probes"][0];
    wall = std::abs(seen["trueDistance"].get<double>() - seen["hitDistance"].get<double>()) < 0.1;
  }
  ASSERT_TRUE(wall);
  const std::string face = json["probes"][0]["face"];
  const auto axis = static_cast<int>(face[1] - 'x');
  window_->editor().commitProbe("Set box", [&](Probe& edited) {
    (face[0] == '+' ? edited.box.max : edited.box.min)[axis] += face[0] == '+' ? 0.7 : -0.7;
  });
  waitUntilIdle();
  EXPECT_TRUE(find<QLabel>("verdict")->text().contains("degrees off")) << find<QLabel>("verdict")->text().toStdString();
  auto* mend = find<QPushButton>("mend");
  ASSERT_TRUE(mend->isVisible());
  keep("verdict");
  QTest::mouseClick(mend, Qt::LeftButton);
  waitUntilIdle();
  EXPECT_TRUE(find<QLabel>("verdict")->text().contains("right to")) << find<QLabel>("verdict")->text().toStdString();
  EXPECT_FALSE(mend->isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window_->editor().scene().probes.front().box == room.box) << "one step";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(window_->editor().scene().probes.front().box == room.box);
  key(Qt::Key_Z, Qt::ControlModifier);
  waitUntilIdle();
}

// A point of the mirror floor whose reflected ray meets a wall: the picture in app/README.md.
TEST_F(DebugViewTest, TheFloorReflectsAWall) {
  const QSize before = window_->size();
  window_->resize(1440, 900);
  const Probe room = loadSceneFile(BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json").probes.front();
  window_->editor().commitProbe("As in the scene", [&](Probe& edited) { edited = room; });
  waitUntilIdle();
  key(Qt::Key_E);
  move(pixelOf({-0.9, 0.0, 1.3}));
  settle();
  EXPECT_TRUE(debug().card()->text().contains("\"mirror\"")) << debug().card()->text().toStdString();
  EXPECT_TRUE(debug().schematic()->isVisible());
  keep("explain");
  key(Qt::Key_Z, Qt::ControlModifier);
  window_->resize(before);
  waitUntilIdle();
}

TEST_F(DebugViewTest, TheCardSaysWhatTheScreenShows) {
  startTool();
  ASSERT_FALSE(debug().card()->empty());
  debug().copyJson();
  const auto json = nlohmann::json::parse(QApplication::clipboard()->text().toStdString());
  EXPECT_LT(json["differenceOfBrightestTexel"].get<double>(), 2e-3);
  debug().copyText();
  EXPECT_TRUE(QApplication::clipboard()->text().contains("<- the smallest"));
  EXPECT_TRUE(debug().card()->text().contains("smallest"));
  for (const char* symbol : {"P", "N", "V", "R", "H"}) EXPECT_TRUE(debug().card()->text().contains(symbol)) << symbol;
  auto* footprint = find<FootprintView>("footprint");
  EXPECT_TRUE(footprint->isVisible());
}

TEST_F(DebugViewTest, AClickPinsAndADragMovesTheCamera) {
  startTool();
  press(shiny_);
  release(shiny_ + QPointF(1, 1));
  ASSERT_TRUE(debug().inspector().pinned());
  waitUntilIdle();
  const QString pinned = debug().card()->text();
  move(shiny_ + QPointF(60, 20));
  waitUntilIdle();
  EXPECT_EQ(debug().card()->text(), pinned);

  const glm::dvec3 eye = window_->viewport().view().eyeWorld();
  drag(shiny_ + QPointF(-80, 0), shiny_ + QPointF(-40, 0));
  waitUntilIdle();
  const glm::dvec3 turned = window_->viewport().view().eyeWorld();
  EXPECT_NE(turned, eye);
  EXPECT_TRUE(debug().inspector().pinned());
  EXPECT_EQ(debug().card()->text(), pinned) << "what was pinned, as it was seen";
  keep("pinned");

  // What is pinned stays live: with the camera elsewhere, a change of the probe reaches it.
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x += 0.4; });
  waitUntilIdle();
  EXPECT_NE(debug().card()->text(), pinned);
  EXPECT_EQ(window_->viewport().view().eyeWorld(), turned);
  debug().copyJson();
  const auto json = nlohmann::json::parse(QApplication::clipboard()->text().toStdString());
  EXPECT_NEAR(json["surface"]["eyeWorld"][0].get<double>(), eye.x, 1e-9);
  EXPECT_LT(json["differenceOfBrightestTexel"].get<double>(), 2e-3);

  key(Qt::Key_Escape);
  EXPECT_FALSE(debug().inspector().pinned());
}

TEST_F(DebugViewTest, AHandleTakesTheClickFirst) {
  startTool();
  const QPointF handle = facePixel({1, true});
  drag(handle, facePixelAfter({1, true}, 0.2));
  EXPECT_TRUE(document().canUndo());
  EXPECT_FALSE(debug().inspector().pinned());
}

TEST_F(DebugViewTest, EverySurfaceViewShowsItsValueUnderThePointer) {
  const QImage picture = shownPicture(window_->viewport());
  auto* readout = window_->viewport().findChild<QLabel*>();
  ASSERT_NE(readout, nullptr);
  for (int view = 1; view < static_cast<int>(surfaceViews().size()); ++view) {
    const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(view)];
    SCOPED_TRACE(std::string(row.id));
    choose("surfaceView", view);
    EXPECT_GT(differingShare(picture, shownPicture(window_->viewport())), 0.05);
    move(shiny_ + QPointF(view, 0));
    waitUntilIdle();
    EXPECT_TRUE(readout->isVisible());
    EXPECT_TRUE(readout->text().startsWith(QString::fromUtf8(row.label.data(), static_cast<int>(row.label.size()))))
        << readout->text().toStdString();
    keep("view-" + QString::fromUtf8(row.id.data(), static_cast<int>(row.id.size())));
  }
  choose("surfaceView", 0);
  EXPECT_LT(differingShare(picture, shownPicture(window_->viewport())), 1e-3);
}

TEST_F(DebugViewTest, ARangeTypedIsLockedAndUnlockedFollowsTheScene) {
  choose("surfaceView", *findSurfaceView("hit-distance"));
  const auto own = window_->renderer().viewRange();
  raise("debug");
  type(find<QWidget>("rangeHigh"), "2.5");
  waitUntilIdle();
  EXPECT_DOUBLE_EQ(window_->renderer().viewRange().second, 2.5);
  auto* lock = find<QCheckBox>("rangeLock");
  EXPECT_TRUE(lock->isChecked());
  QTest::mouseClick(lock, Qt::LeftButton, {}, QPoint(8, lock->height() / 2));
  EXPECT_EQ(window_->renderer().viewRange(), own);
}

TEST_F(DebugViewTest, RaysFromEverySource) {
  startTool();
  raise("debug");
  for (const QPointF& at : {shiny_, shiny_ + QPointF(90, 10)}) {
    press(at);
    release(at);
    waitUntilIdle();
  }
  const struct {
    RaySource source;
    long long least;
  } sources[] = {{RaySource::Clicked, 6}, {RaySource::Object, 40}, {RaySource::Line, 40}, {RaySource::Screen, 40}};
  for (const auto& [source, least] : sources) {
    choose("raySource", static_cast<int>(source));
    EXPECT_GE(debug().rays().rays(), least)
        << static_cast<int>(source) << ": " << debug().rays().status().toStdString();
    keep(QString("rays-%1").arg(static_cast<int>(source)));
  }
  // A grid over the picture stays when the tool goes off, and goes with its own switch.
  debug().setTool(false);
  waitUntilIdle();
  EXPECT_TRUE(debug().rays().visible());
  auto* shown = find<QCheckBox>("showRays");
  QTest::mouseClick(shown, Qt::LeftButton, {}, QPoint(8, shown->height() / 2));
  waitUntilIdle();
  EXPECT_FALSE(debug().rays().visible());
  QTest::mouseClick(shown, Qt::LeftButton, {}, QPoint(8, shown->height() / 2));
  choose("raySource", 0);
}

TEST_F(DebugViewTest, RaysAreSavedAsPolyDataThatReadsBack) {
  startTool();
  QTemporaryDir folder;
  const QString path = folder.filePath("rays.vtp");
  QString failure;
  const auto listening =
      QObject::connect(&debug(), &DebugView::failed, [&failure](const QString& line) { failure = line; });
  answerFileDialog(path);
  debug().saveRays();
  QObject::disconnect(listening);
  EXPECT_EQ(failure.toStdString(), "");
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.toUtf8().constData());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLines(), debug().rays().rays());
  EXPECT_GT(debug().rays().rays(), 0);
}

TEST_F(DebugViewTest, TheBackgroundIsSaidToBeOne) {
  startTool();
  move(sky_);
  settle();
  debug().copyJson();
  const auto json = nlohmann::json::parse(QApplication::clipboard()->text().toStdString());
  EXPECT_EQ(json["background"], true);
  EXPECT_FALSE(json["notes"].empty());
  EXPECT_FALSE(debug().schematic()->isVisible());
  EXPECT_FALSE(debug().rays().visible());
  keep("background");
  // A surface without a probe says so too: the notes come first on the card.
  window_->editor().commitProbe("Set influence", [](Probe& edited) {
    edited.influence = Box{{40.0, 40.0, 40.0}, {41.0, 41.0, 41.0}};
  });
  move(shiny_);
  waitUntilIdle();
  EXPECT_TRUE(debug().card()->text().contains("No probe")) << debug().card()->text().toStdString();
  keep("no-probe");
}

TEST_F(DebugViewTest, AMoveExplainsOnePixelAndDrawsNoPicture) {
  startTool();
  const auto seconds = [](int times, const auto& work) {
    const double before = processCpuSeconds();
    for (int i = 0; i < times; ++i) work(i);
    return (processCpuSeconds() - before) / times;
  };
  window_->viewport().window3d()->MakeCurrent();
  const double picture = seconds(5, [this](int) { window_->viewport().window3d()->Render(); });
  const Counters before = counters();
  const std::uint64_t explained = explanations();
  constexpr int kMoves = 20;
  const double layer = seconds(kMoves, [this](int i) {
    emit window_->viewport().pointerMoved(shiny_ + QPointF(i, 0));
    debug().update();
  });
  EXPECT_EQ(explanations(), explained + kMoves);
  EXPECT_EQ(counters().renders, before.renders) << "an explanation draws one pixel, not the picture";
  EXPECT_EQ(counters().programsCompiled, before.programsCompiled);
  EXPECT_EQ(counters().facesCaptured, before.facesCaptured);
  std::printf("[ MEASURED ] picture %.2f ms, debug layer %.2f ms a move, CPU\n", 1e3 * picture, 1e3 * layer);
}

}  // namespace
}  // namespace boxprobe
