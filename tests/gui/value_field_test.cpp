// Steps, wheel and scrubbing: previewed as they go, one undo step in the end.
#include "app/gui/widgets/value_field.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>
#include <QStatusBar>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QTest>
#include <QWheelEvent>

#include "app/gui/view/viewport.h"
#include "app/gui/widgets/scrub_label.h"
#include "app/gui/widgets/vector_row.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class ValueFieldTest : public WindowTest {
 protected:
  static constexpr int kNoRest = 24 * 3600 * 1000;  // whatever else the machine is doing

  void SetUp() override {
    WindowTest::SetUp();
    for (ValueField* each : window_->findChildren<ValueField*>()) each->setRest(kNoRest);
  }
  void TearDown() override {
    for (ValueField* each : window_->findChildren<ValueField*>()) each->setRest(ValueField::kRestMilliseconds);
  }
  ValueField* field(const char* name) const { return window_->findChild<ValueField*>(name); }
  /// After the rest that users have, from now on.
  bool restsAsOneStep(ValueField* edited) {
    edited->setRest(ValueField::kRestMilliseconds);
    const bool settled = QTest::qWaitFor([this] { return !document().previewing(); }, 60000);
    edited->setRest(kNoRest);
    document().undo();
    return settled && !document().canUndo();
  }
};

TEST_F(ValueFieldTest, StepsThatFollowEachOtherAreOneUndoStep) {
  ValueField* intensity = field("intensity");
  intensity->setFocus();
  for (int i = 0; i < 4; ++i) key(Qt::Key_Up);
  EXPECT_TRUE(document().previewing());
  EXPECT_NEAR(probe().intensity, 1.2, 1e-9) << "steps must show at once";
  EXPECT_TRUE(restsAsOneStep(intensity));
  EXPECT_EQ(probe().intensity, 1.0);
}

TEST_F(ValueFieldTest, AnotherEditCommitsTheStepsFirst) {
  ValueField* intensity = field("intensity");
  intensity->setFocus();
  key(Qt::Key_Up);
  type(window_->findChild<VectorRow*>("origin")->field(0), "0.5");
  EXPECT_EQ(document().undoLabel(), "Set origin X of room");
  document().undo();
  EXPECT_EQ(document().undoLabel(), "Set intensity of room");
  EXPECT_NEAR(probe().intensity, 1.05, 1e-9);
}

TEST_F(ValueFieldTest, StepsAfterTheFieldWasLeftAreOneUndoStepAgain) {
  ValueField* intensity = field("intensity");
  intensity->setFocus();
  key(Qt::Key_Up);
  window_->viewport().setFocus();
  EXPECT_TRUE(QTest::qWaitFor([this] { return !document().previewing(); }, 60000)) << "leaving the field commits";
  document().undo();
  intensity->setFocus();
  for (int i = 0; i < 4; ++i) key(Qt::Key_Up);
  EXPECT_TRUE(document().previewing()) << "the steps are one edit that goes on";
  EXPECT_TRUE(restsAsOneStep(intensity));
  EXPECT_EQ(probe().intensity, 1.0);
}

TEST_F(ValueFieldTest, TheWheelChangesOnlyTheFieldInUse) {
  ValueField* intensity = field("intensity");
  const auto turn = [&] {
    QWheelEvent event(QPointF(5, 5), intensity->mapToGlobal(QPoint(5, 5)), {}, {0, 120}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(intensity, &event);
  };
  window_->viewport().setFocus();
  turn();
  EXPECT_EQ(probe().intensity, 1.0);
  intensity->setFocus();
  turn();
  turn();
  EXPECT_NEAR(probe().intensity, 1.1, 1e-9);
  EXPECT_TRUE(restsAsOneStep(intensity));
}

TEST_F(ValueFieldTest, ScrubbingALabelIsOneStep) {
  auto* row = window_->findChild<VectorRow*>("boxMax");
  ScrubLabel* label = row->findChildren<ScrubLabel*>().at(1);
  const double before = probe().box.max.y;
  dragOver(label, {3, 8}, {63, 8}, 12);  // sixty pixels: six steps of 0.1 m
  EXPECT_NEAR(probe().box.max.y, before + 0.6, 1e-9);
  EXPECT_FALSE(document().previewing()) << "letting go must commit";
  EXPECT_EQ(document().undoLabel(), "Set box max Y of room");
  document().undo();
  EXPECT_EQ(probe().box.max.y, before);
  EXPECT_FALSE(document().canUndo());
}

TEST_F(ValueFieldTest, OneSeparatorIsTheDecimalMarkInEveryLocale) {
  ValueField* x = window_->findChild<VectorRow*>("origin")->field(0);
  for (const char* locale : {"de_DE", "ar_EG", "en_US"}) {
    QLocale::setDefault(QLocale(locale));
    ValueField fresh({-100000.0, 100000.0, 0.1, 3, " m"});
    fresh.show(15000.0);
    EXPECT_EQ(fresh.text(), "15000.000 m") << locale;
    for (const char* text : {"1.5", "1,5"}) {
      type(x, text);
      EXPECT_EQ(probe().origin.x, 1.5) << locale << " " << text;
      EXPECT_EQ(x->text().split(' ').front(), "1.500");
      document().undo();
    }
  }
  QLocale::setDefault(QLocale::c());
}

// The blend distance of unequal faces says "up to" before the largest.
TEST_F(ValueFieldTest, ANumberIsTypedOverTheOneBehindAWord) {
  window_->editor().commitProbe("Blend", [](Probe& probe) { probe.blendDistance.max.x = 0.66; });
  waitUntilIdle();
  auto* row = window_->findChild<QWidget*>("blendDistance");
  ASSERT_NE(row, nullptr);
  auto* all = row->findChild<ValueField*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_NE(all, nullptr);
  ASSERT_EQ(all->text(), "up to 0.660 m");
  type(all, "0.25");
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(probe().blendDistance.min[axis], 0.25);
    EXPECT_EQ(probe().blendDistance.max[axis], 0.25);
  }
  EXPECT_EQ(all->text(), "0.250 m");
  document().undo();
  document().undo();
}

TEST_F(ValueFieldTest, TwoSeparatorsAreRefusedWithALine) {
  ValueField* x = window_->findChild<VectorRow*>("origin")->field(0);
  const double before = probe().origin.x;
  const QString shown = x->text();
  QString why;
  const auto told = QObject::connect(x, &ValueField::refused, x, [&why](const QString& line) { why = line; });
  type(x, "1,234.5");
  EXPECT_TRUE(why.contains("\"1,234.5\" has more than one separator")) << why.toStdString();
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains("more than one separator"));
  EXPECT_EQ(probe().origin.x, before);
  EXPECT_EQ(x->text(), shown) << "the value from before comes back";
  EXPECT_FALSE(document().canUndo());
  QObject::disconnect(told);
}

TEST_F(ValueFieldTest, LeavingAFieldUntouchedEditsNothing) {
  auto* row = window_->findChild<VectorRow*>("boxMax");
  // A value with more digits than are shown.
  window_->editor().commitProbe("Set", [](Probe& edited) { edited.box.max.x = 4.12345678; });
  row->field(0)->setFocus();
  row->field(1)->setFocus();
  key(Qt::Key_Return);
  EXPECT_EQ(probe().box.max.x, 4.12345678);
  document().undo();
  EXPECT_FALSE(document().canUndo());
}

}  // namespace
}  // namespace boxprobe
