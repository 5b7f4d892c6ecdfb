// Probes placed as their user sees it: a flat is dropped, a key pressed, the list reviewed and applied as one step.
#include "app/gui/panels/place_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <atomic>
#include <cmath>
#include <thread>

#include "app/gui/edit/background_work.h"
#include "data/scenes/glb_writer.h"
#include "tests/gui/window_test.h"
#include "tests/support/made_flat.h"

namespace boxprobe {
namespace {

TEST(BackgroundWork, SaysHowMuchIsDone) {
  BackgroundWork work;
  std::atomic<bool> goOn{false};
  work.start([&goOn](const BackgroundWork::Progress& progress) {
    progress(0.375);
    while (!goOn) std::this_thread::yield();
    return BackgroundWork::Finish([] {});
  });
  EXPECT_TRUE(QTest::qWaitFor([&work] { return work.percent() == 37; }, 60000)) << work.percent();
  goOn = true;
}

class PlacePanelTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    panel()->setPaths(8);
    QObject::connect(panel(), &PlacePanel::ghostsChanged, &context_,
                     [this](const std::vector<Probe>& ghosts) { ghosts_ = ghosts; });
  }
  PlacePanel* panel() { return window_->findChild<PlacePanel*>(); }
  template <typename Widget>
  Widget* find(const char* name) {
    Widget* found = window_->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void dropFlat() {
    test::FlatWishes wishes;
    wishes.unitsPerMetre = 100.0;
    wishes.yawDegrees = 25.0;
    wishes.groundMetres = 80.0;
    QFile file(folder_.filePath("flat.glb"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    const std::string bytes = scenes::glbBytes(test::madeFlat(wishes));
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    dropFile(file.fileName());
    ASSERT_TRUE(QString::fromStdString(document().scene().models.front().file).endsWith("flat.glb"));
  }
  void dropFile(const QString& name) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(name)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_, &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_, &event);
    waitUntilIdle();
  }
  void placeByKey() {
    ASSERT_TRUE(ghosts_.empty());
    key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(waitFor([this] { return !ghosts_.empty() && !panel()->running(); }));
    waitUntilIdle();
  }
  void click(const char* name) {
    auto* button = find<QPushButton>(name);
    ASSERT_TRUE(button->isVisible() && button->isEnabled()) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }

  QObject context_;  // the window outlives the test
  QTemporaryDir folder_;
  std::vector<Probe> ghosts_;
};

TEST_F(PlacePanelTest, ADroppedFlatOfTwoRoomsGetsTwoProbesAndOneUndoRestoresIt) {
  dropFlat();
  const Scene before = document().scene();
  placeByKey();
  ASSERT_EQ(ghosts_.size(), 2u);
  EXPECT_TRUE(document().scene().probes == before.probes) << "nothing counts before it is applied";
  for (const char* reason : {"placedReason0", "placedReason1"}) {
    const QString words = find<QLabel>(reason)->text();
    EXPECT_TRUE(words.contains("room")) << words.toStdString() << ": why it is there";
  }
  const QString output = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
  if (!output.isEmpty()) window_->grab().save(output + "/place.png");

  click("applyPlaced");
  ASSERT_EQ(document().scene().probes.size(), 2u);
  EXPECT_TRUE(ghosts_.empty());
  for (const Probe& placed : document().scene().probes) {
    EXPECT_NEAR(std::remainder(placed.rotationDegrees.y - 25.0, 90.0), 0.0, 0.5) << placed.name;
    EXPECT_NEAR(placed.box.size().y, 260.0, 3.0) << placed.name;
    EXPECT_LT(placed.box.size().x + placed.box.size().z, 810.0) << placed.name << " is no larger than its room";
  }
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().scene().probes == before.probes);
}

// What is tried is told beside the errors. Of a bare model captures of one bounce are, too, but not once somebody has
// chosen their number.
TEST_F(PlacePanelTest, ABareRoomIsTriedAsTheCommandTriesIt) {
  dropFile(BOXPROBE_DATA_DIR "/scenes/room.glb");
  const auto tried = [this] {
    panel()->place();
    EXPECT_TRUE(waitFor([this] { return !panel()->running(); }));
    waitUntilIdle();
    const QString words = find<QLabel>("placeErrors")->toolTip();
    EXPECT_TRUE(words.contains("one box around all of the model")) << words.toStdString();
    return words.contains("bounces of light: 1;") || words.contains("bounces of light in the captures: 1;");
  };
  EXPECT_TRUE(tried());
  window_->editor().commit("Bounces", [](Scene& scene) { scene.probes.front().bounces = 2; });
  waitUntilIdle();
  EXPECT_FALSE(tried());
}

TEST_F(PlacePanelTest, ProbesAreAcceptedOneByOneAndAdded) {
  dropFlat();
  const std::size_t before = document().scene().probes.size();
  placeByKey();
  ASSERT_EQ(ghosts_.size(), 2u);
  find<QCheckBox>("placedProbe0")->setChecked(false);
  ASSERT_EQ(ghosts_.size(), 1u);
  const Box second = ghosts_[0].box;
  if (before > 0) find<QCheckBox>("replaceProbes")->setChecked(false);
  click("applyPlaced");
  ASSERT_EQ(document().scene().probes.size(), before + 1);
  EXPECT_TRUE(document().scene().probes.back().box == second);
}

TEST_F(PlacePanelTest, StopsWhenAskedAndIsDroppedWhenTheSceneChanges) {
  panel()->place();
  ASSERT_TRUE(panel()->running());
  EXPECT_TRUE(find<QPushButton>("placeProbes")->text().startsWith("Stop"));
  panel()->place();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !panel()->running(); }, 60000));
  EXPECT_TRUE(ghosts_.empty());
  EXPECT_FALSE(find<QPushButton>("applyPlaced")->isVisible());

  dropFlat();
  placeByKey();
  ASSERT_FALSE(ghosts_.empty());
  window_->editor().commit("Add", [](Scene& scene) { scene.probes.emplace_back().name = "mine"; });
  waitUntilIdle();
  EXPECT_TRUE(ghosts_.empty());
  EXPECT_FALSE(find<QPushButton>("applyPlaced")->isVisible());
}

}  // namespace
}  // namespace boxprobe
