// The lights' section: shadows chosen, softened and undone, and what the picture looks up for it.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <glm/geometric.hpp>

#include "app/gui/panels/light_panel.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/value_field.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class LightTest : public WindowTest {
 protected:
  void choose(const char* name, int item) {
    auto* combo = window_->findChild<QComboBox*>(name);
    combo->setCurrentIndex(item);
    emit combo->activated(item);
  }
};

TEST_F(LightTest, ShadowsAreAChoiceAndTheirSoftnessAField) {
  auto* angle = window_->findChild<ValueField*>("lightAngle");
  ASSERT_NE(angle, nullptr);
  bring(angle);
  EXPECT_FALSE(angle->isVisibleTo(window_)) << "of a light without shadows there is nothing to soften";
  choose("lightShadows", 1);
  EXPECT_EQ(document().scene().lights[0].shadows, LightShadows::Coverage);
  EXPECT_EQ(document().undoLabel(), "Set shadows of light 1");
  EXPECT_TRUE(angle->isVisibleTo(window_));
  waitUntilIdle();
  EXPECT_GT(counters().drawsWithCoverage, 0u);
  type(angle, "4");
  EXPECT_EQ(document().scene().lights[0].angleDegrees, 4.0);
  document().undo();
  document().undo();
  waitUntilIdle();
  EXPECT_EQ(document().scene().lights[0].shadows, LightShadows::None);
  EXPECT_EQ(counters().drawsWithCoverage, 0u);
}

TEST_F(LightTest, LightsAreAddedColouredAimedAndDeleted) {
  const std::size_t count = document().scene().lights.size();
  auto* panel = window_->findChild<LightPanel*>();
  QMenu* kinds = window_->findChild<QPushButton*>("addLight")->menu();
  kinds->actions().at(2)->trigger();
  ASSERT_EQ(document().scene().lights.size(), count + 1);
  const Camera camera = window_->renderer().currentCamera();
  const auto light = [&] { return document().scene().lights.back(); };
  EXPECT_EQ(light().type, LightType::Spot);
  EXPECT_EQ(light().position, camera.position);
  EXPECT_NEAR(glm::length(light().direction - glm::normalize(camera.target - camera.position)), 0.0, 1e-12);
  EXPECT_EQ(window_->findChild<QComboBox*>("light")->currentIndex(), static_cast<int>(count))
      << "it is the one on show";
  panel->setColor(QColor(255, 0, 0));
  EXPECT_EQ(light().color, glm::vec3(1.0F, 0.0F, 0.0F));
  key(Qt::Key_2, Qt::ControlModifier);
  QTest::mouseClick(window_->findChild<QPushButton*>("aimLight"), Qt::LeftButton);
  EXPECT_EQ(light().position, window_->renderer().currentCamera().position);
  QTest::mouseClick(window_->findChild<QPushButton*>("deleteLight"), Qt::LeftButton);
  EXPECT_EQ(document().scene().lights.size(), count);
  for (int i = 0; i < 4; ++i) document().undo();
  EXPECT_FALSE(document().canUndo());
}

TEST_F(LightTest, LampsAreShapesUnlessTheyAreChosenToLieInTheMap) {
  auto* lamps = window_->findChild<QComboBox*>("lamps");
  ASSERT_NE(lamps, nullptr);
  EXPECT_EQ(lamps->currentIndex(), 0);
  EXPECT_EQ(document().scene().lamps, LampForm::Shapes);
  choose("lamps", 1);
  EXPECT_EQ(document().scene().lamps, LampForm::InMap);
  EXPECT_EQ(document().undoLabel(), "Set lamps");
  waitUntilIdle();
  document().undo();
  EXPECT_EQ(lamps->currentIndex(), 0);
  EXPECT_FALSE(document().canUndo());
}

TEST_F(LightTest, TheSkyIsTurnedInOneStep) {
  auto* turn = window_->findChild<ValueField*>("skyTurn");
  ASSERT_NE(turn, nullptr);
  type(turn, "30");
  EXPECT_EQ(document().scene().skyRotationDegrees, 30.0);
  document().undo();
  EXPECT_EQ(document().scene().skyRotationDegrees, 0.0);
  EXPECT_FALSE(document().canUndo());
}

TEST_F(LightTest, ASkyWithoutAPictureIsNotTurnedByTheHand) {
  drag({120.0, 40.0}, {180.0, 40.0}, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().scene().skyRotationDegrees, 0.0);
  EXPECT_FALSE(document().canUndo());
}

class SkyPictureTest : public LightTest {
 protected:
  LoadedScene scene() const override {
    LoadedScene loaded = smallBuilding();
    loaded.scene.sky = SkyImage{BOXPROBE_DATA_DIR "/scenes/sky.hdr"};
    return loaded;
  }
  double turned() { return document().scene().skyRotationDegrees; }
};

// What is straight ahead stays under the pointer; a drag is one step, and so is each press of a key.
TEST_F(SkyPictureTest, FollowsTheHandAndTheKeys) {
  const Camera before = window_->renderer().currentCamera();
  drag({120.0, 40.0}, {180.0, 45.0}, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NEAR(turned(), -60.0 * before.verticalFovDegrees / window_->viewport().height(), 0.06);
  EXPECT_EQ(window_->renderer().currentCamera().position, before.position) << "the camera was moved";
  document().undo();
  EXPECT_EQ(turned(), 0.0) << "more than one step";
  EXPECT_FALSE(document().canUndo());
  key(Qt::Key_Left, Qt::AltModifier);
  key(Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(turned(), 10.0);
  key(Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(turned(), 5.0);
  document().undo();
  EXPECT_EQ(turned(), 10.0);
}

}  // namespace
}  // namespace boxprobe
