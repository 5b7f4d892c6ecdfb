// The lights' section: shadows chosen, softened and undone, and what the picture looks up for it.
#include <gtest/gtest.h>

#include <QComboBox>

#include "app/gui/widgets/value_field.h"
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

TEST_F(LightTest, TheSkyIsTurnedInOneStep) {
  auto* turn = window_->findChild<ValueField*>("skyTurn");
  ASSERT_NE(turn, nullptr);
  type(turn, "30");
  EXPECT_EQ(document().scene().skyRotationDegrees, 30.0);
  document().undo();
  EXPECT_EQ(document().scene().skyRotationDegrees, 0.0);
  EXPECT_FALSE(document().canUndo());
}

}  // namespace
}  // namespace boxprobe
