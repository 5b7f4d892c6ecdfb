// A fit as its user sees it: asked for by a key, reviewed face by face, applied as one step.
#include "app/gui/panels/fit_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <optional>

#include "app/gui/panels/probe_commands.h"
#include "filters/io/scene/scene_file.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class FitPanelTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    QObject::connect(panel(), &FitPanel::ghostChanged, &context_,
                     [this](const std::optional<Probe>& ghost) { ghost_ = ghost; });
    right_ = loadSceneFile(BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json").probes.front();
    window_->editor().commitProbe("Set box", [this](Probe& probe) {
      probe.origin = right_.origin;
      probe.box = right_.box;
      probe.box.max.x += 1.5;
      probe.box.min.z -= 1.0;
    });
    waitUntilIdle();
    wrong_ = shown().box;
  }
  FitPanel* panel() { return window_->findChild<FitPanel*>(); }
  const Probe& shown() { return window_->editor().scene().probes.front(); }
  void fit() {
    ASSERT_FALSE(ghost_);
    key(Qt::Key_F, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([this] { return ghost_ && !panel()->running(); }));
    waitUntilIdle();
  }
  template <typename Widget>
  Widget* find(const char* name) {
    Widget* found = window_->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }

  QObject context_;  // the window outlives the test
  std::optional<Probe> ghost_;
  Probe right_;
  Box wrong_;
};

TEST_F(FitPanelTest, IsReviewedAndAppliedAsOneStep) {
  fit();
  ASSERT_TRUE(ghost_);
  EXPECT_TRUE(find<QLabel>("fitErrors")->isVisible());
  EXPECT_TRUE(shown().box == wrong_) << "nothing counts before it is applied";
  const QString folder = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
  if (!folder.isEmpty()) window_->grab().save(folder + "/fit.png");

  // Without the face +x (number 1) that one stays; with it both mended faces are where they were.
  auto* face = find<QCheckBox>("fitFace1");
  face->setChecked(false);
  EXPECT_NEAR(ghost_->box.max.x, wrong_.max.x, 1e-6);
  EXPECT_NEAR(ghost_->box.min.z, right_.box.min.z, 0.1);
  face->setChecked(true);
  QTest::mouseClick(find<QPushButton>("applyFit"), Qt::LeftButton);
  waitUntilIdle();
  EXPECT_NEAR(shown().box.max.x, right_.box.max.x, 0.1);
  EXPECT_NEAR(shown().box.min.z, right_.box.min.z, 0.1);
  EXPECT_FALSE(ghost_);
  EXPECT_FALSE(find<QLabel>("fitErrors")->isVisible());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(shown().box == wrong_);
}

TEST_F(FitPanelTest, AnAddedProbeIsFittedAndWaitsForAYes) {
  window_->findChild<ProbeCommands*>()->addProbe();
  const std::size_t last = window_->editor().scene().probes.size() - 1;
  ASSERT_TRUE(panel()->running());
  ASSERT_TRUE(QTest::qWaitFor([this] { return !panel()->running(); }, 120000));
  const Box everything = probe(last).box;
  ASSERT_TRUE(ghost_);
  EXPECT_FALSE(ghost_->box == everything);
  QTest::mouseClick(find<QPushButton>("applyFit"), Qt::LeftButton);
  waitUntilIdle();
  EXPECT_FALSE(probe(last).box == everything);
  EXPECT_TRUE(shown().box == wrong_) << "the other probe's";
}

TEST_F(FitPanelTest, IsDroppedWhenTheProbeChangesAndStopsOnAsking) {
  fit();
  ASSERT_TRUE(ghost_);
  window_->editor().commitProbe("Move", [](Probe& probe) { probe.origin.y += 0.1; });
  waitUntilIdle();
  EXPECT_FALSE(ghost_);
  EXPECT_FALSE(find<QPushButton>("applyFit")->isVisible());

  panel()->fit();
  ASSERT_TRUE(panel()->running());
  EXPECT_TRUE(find<QPushButton>("fitBox")->text().startsWith("Stop"));
  panel()->fit();
  EXPECT_TRUE(QTest::qWaitFor([this] { return !panel()->running(); }, 60000));
  EXPECT_FALSE(ghost_);
}

}  // namespace
}  // namespace boxprobe
