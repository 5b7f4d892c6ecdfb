// Dragging the capture origin: where it goes, what is captured while and after, how undo brings it back.
#include <gtest/gtest.h>

#include <QMouseEvent>
#include <QTest>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class DragOriginTest : public WindowTest {
 protected:
  LoadedScene scene() const override { return smallBuilding({"probes.room.bounces=2"}); }
  static constexpr std::uint64_t kFacesOfOneCapture = 12;  // six of each bounce
};

TEST_F(DragOriginTest, CapturesOnTheWayAndOnceMoreWhenItRests) {
  const glm::dvec3 before = probe().origin;
  const std::uint64_t facesBefore = counters().facesCaptured;
  const QPointF from = originPixel();
  const QPointF to = from + QPointF(60, -40);
  press(from);
  for (int i = 1; i <= 10; ++i) move(from + (to - from) * i / 10);
  const auto capturedOnce = [&] { return counters().facesCaptured >= facesBefore + 6; };
  EXPECT_TRUE(waitFor(capturedOnce)) << "nothing was captured while the origin was dragged";
  EXPECT_TRUE(document().previewing());

  // Delivered by itself, so that no work goes on between it and the count.
  const QPointF onScreen = window_->viewport().mapToGlobal(to.toPoint());
  QMouseEvent released(QEvent::MouseButtonRelease, to, onScreen, Qt::LeftButton, Qt::NoButton, {});
  QCoreApplication::sendEvent(&window_->viewport(), &released);
  EXPECT_FALSE(document().previewing());
  const std::uint64_t facesAtRest = counters().facesCaptured;
  release(to);
  waitUntilIdle();
  EXPECT_EQ(counters().facesCaptured - facesAtRest, kFacesOfOneCapture);
  QTest::qWait(100);
  EXPECT_EQ(counters().facesCaptured - facesAtRest, kFacesOfOneCapture) << "captured again without a reason";

  EXPECT_EQ(document().undoLabel(), "Move origin of room");
  EXPECT_FALSE(probe().origin == before);
  document().undo();
  EXPECT_TRUE(probe().origin == before);
  EXPECT_FALSE(document().canUndo());
}

TEST_F(DragOriginTest, HeldStillItIsCapturedOnceAndThenNothingRuns) {
  const QPointF from = originPixel();
  press(from);
  move(from + QPointF(30, 10));
  const auto resting = [this] { return window_->scheduler().idle() && !window_->renderer().workPending(); };
  EXPECT_TRUE(QTest::qWaitFor(resting, 60000)) << "captured over and over while nothing moves";
  release(from + QPointF(30, 10));
}

TEST_F(DragOriginTest, MovesParallelToTheScreen) {
  const glm::dvec3 before = probe().origin;
  const QPointF to = originPixel() + QPointF(80, 50);
  drag(originPixel(), to);
  const glm::dvec3 forward = window_->viewport().view().axes().forward;
  EXPECT_NEAR(glm::dot(probe().origin - before, forward), 0.0, 1e-9);
  EXPECT_LT(std::hypot(originPixel().x() - to.x(), originPixel().y() - to.y()), 0.5);
}

TEST_F(DragOriginTest, ShiftMovesATenthAsFar) {
  const QPointF from = originPixel();
  drag(from, from + QPointF(100, -60), Qt::ShiftModifier);
  EXPECT_NEAR(originPixel().x() - from.x(), 10.0, 0.5);
  EXPECT_NEAR(originPixel().y() - from.y(), -6.0, 0.5);
}

TEST_F(DragOriginTest, CtrlPutsItOnTheGrid) {
  drag(originPixel(), originPixel() + QPointF(37, -23), Qt::ControlModifier);
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = probe().origin[axis] / 0.1;
    EXPECT_NEAR(steps, std::round(steps), 1e-9) << axis;
  }
}

TEST_F(DragOriginTest, AHeldLetterMovesAlongThatAxisOnly) {
  const glm::dvec3 before = probe().origin;
  const QPointF from = originPixel();
  press(from);
  move(from + QPointF(40, -30));
  keyDown(Qt::Key_X);
  EXPECT_NE(probe().origin.x, before.x);
  EXPECT_EQ(probe().origin.y, before.y);
  EXPECT_EQ(probe().origin.z, before.z);
  keyUp(Qt::Key_X);
  EXPECT_NE(probe().origin.y, before.y);
  keyDown(Qt::Key_Z);
  release(from + QPointF(40, -30));
  keyUp(Qt::Key_Z);
  EXPECT_NE(probe().origin.z, before.z);
  EXPECT_EQ(probe().origin.x, before.x);
}

TEST_F(DragOriginTest, UndoShowsTheEarlierCaptureWithoutTakingItAgain) {
  drag(originPixel(), originPixel() + QPointF(50, 0));
  waitUntilIdle();
  const std::uint64_t faces = counters().facesCaptured;
  key(Qt::Key_Z, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_FALSE(document().canUndo());
  EXPECT_EQ(counters().facesCaptured, faces);
}

TEST_F(DragOriginTest, EscapeStopsCapturingAndTheNextChangeGoesOn) {
  const double before = probe().origin.x;
  window_->editor().commitProbe("Set origin", [](Probe& edited) { edited.origin.x += 0.5; });
  ASSERT_TRUE(window_->renderer().workPending());
  while (window_->renderer().workProgress() < 0.05) QCoreApplication::processEvents();
  key(Qt::Key_Escape);
  QTest::qWait(50);
  EXPECT_TRUE(window_->scheduler().workStopped());
  EXPECT_TRUE(window_->renderer().workPending());
  const std::uint64_t faces = counters().facesCaptured;
  QTest::qWait(100);
  EXPECT_EQ(counters().facesCaptured, faces);
  window_->scheduler().resumeWork();
  waitUntilIdle();
  EXPECT_FALSE(window_->renderer().workPending());
  EXPECT_EQ(probe().origin.x, before + 0.5);
}

}  // namespace
}  // namespace boxprobe
