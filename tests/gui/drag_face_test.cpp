// Dragging the faces of the box: the document's numbers, one undo step, and nothing computed that the picture does not
// need.
#include <gmock/gmock.h>

#include <QAbstractEventDispatcher>
#include <QMouseEvent>
#include <QTest>
#include <cmath>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class DragFaceTest : public WindowTest {
 protected:
  static constexpr BoxFace kPlusX{0, true};
  static constexpr BoxFace kMinusY{1, false};
  static constexpr BoxFace kMinusZ{2, false};
};

/// Of the box, apart from the one number that `face` is.
void expectOthersSame(const Box& before, const Box& after, const BoxFace& face) {
  for (const BoxFace& other : kBoxFaces) {
    if (other == face) continue;
    const glm::dvec3& was = other.positive ? before.max : before.min;
    const glm::dvec3& is = other.positive ? after.max : after.min;
    EXPECT_EQ(was[other.axis], is[other.axis]) << faceName(other) << " moved with " << faceName(face);
  }
}

double outwards(const Box& before, const Box& after, const BoxFace& face) {
  return face.positive ? after.max[face.axis] - before.max[face.axis] : before.min[face.axis] - after.min[face.axis];
}

TEST_F(DragFaceTest, MovesThatFaceAlongItsAxisOnlyInOneUndoStep) {
  for (const BoxFace& face : kBoxFaces) {
    SCOPED_TRACE(faceName(face));
    const Box before = probe().box;
    const bool couldUndo = document().canUndo();
    for (const double metres : {-0.8, 0.5}) {
      const Box start = probe().box;
      const QPointF target = facePixelAfter(face, metres);
      drag(facePixel(face), target);
      expectOthersSame(start, probe().box, face);
      // The pointer went along the axis' picture, so the face must have gone just as far: to a pixel's worth of metres.
      EXPECT_NEAR(outwards(start, probe().box, face), metres, 0.03);
      EXPECT_EQ(document().undoLabel(), std::string("Move face ") + faceName(face) + " of room");
      EXPECT_LT(std::hypot(facePixel(face).x() - target.x(), facePixel(face).y() - target.y()), 1.5);
    }
    document().undo();
    document().undo();
    EXPECT_TRUE(probe().box == before);
    EXPECT_EQ(document().canUndo(), couldUndo);
  }
}

TEST_F(DragFaceTest, CapturesFiltersAndCompilesNothing) {
  // The pointer over the handle first: its highlight may be drawn for the first time.
  move(facePixel(kPlusX));
  waitUntilIdle();
  const Counters before = counters();
  std::uint64_t turns = 0;
  const auto counting =
      QObject::connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::awake, [&turns] { ++turns; });
  const QPointF from = facePixel(kPlusX);
  const QPointF to = facePixelAfter(kPlusX, -2.0);
  press(from);
  constexpr int kMoves = 30;
  for (int i = 1; i <= kMoves; ++i) move(from + (to - from) * i / kMoves);
  release(to);
  QObject::disconnect(counting);
  waitUntilIdle();

  EXPECT_GE(counters().renders, before.renders + kMoves / 2) << "the picture must follow the drag";
  EXPECT_LE(counters().renders - before.renders, turns + 1);
  EXPECT_EQ(counters().facesCaptured, before.facesCaptured);
  EXPECT_EQ(counters().levelsFiltered, before.levelsFiltered);
  EXPECT_EQ(counters().programsCompiled, before.programsCompiled);
  EXPECT_NEAR(probe().box.max.x, -0.5, 0.03);
}

TEST_F(DragFaceTest, ManyMovesInOneTurnMakeOnePicture) {
  const QPointF from = facePixel(kPlusX);
  const QPointF to = facePixelAfter(kPlusX, -1.0);
  press(from);
  move(from + (to - from) * 0.1);
  waitUntilIdle();
  const std::uint64_t before = counters().renders;
  constexpr int kMoves = 40;
  for (int i = 1; i <= kMoves; ++i) {
    const QPointF at = from + (to - from) * i / kMoves;
    const QPointF onScreen = window_->viewport().mapToGlobal(at.toPoint());
    QMouseEvent event(QEvent::MouseMove, at, onScreen, Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window_->viewport(), &event);
  }
  waitUntilIdle();
  EXPECT_EQ(counters().renders, before + 1);
  release(to);
  EXPECT_NEAR(probe().box.max.x, 0.5, 0.03);
}

TEST_F(DragFaceTest, StopsAtTheMinimumThicknessInsteadOfTurningInsideOut) {
  const Box before = probe().box;
  const QPointF through = facePixelAfter(kMinusZ, -before.size().z - 0.7);  // beyond the face opposite
  const QPointF from = facePixel(kMinusZ);
  move(from);
  press(from);
  double thinnest = before.size().z;
  for (int i = 1; i <= 20; ++i) {
    move(from + (through - from) * i / 20);
    thinnest = std::min(thinnest, probe().box.size().z);
    ASSERT_GE(probe().box.size().z, kMinimumThickness - 1e-12);
  }
  EXPECT_NEAR(thinnest, kMinimumThickness, 1e-9);
  // Absolute, not added up: back at the start everything is as it was.
  move(from);
  EXPECT_NEAR(probe().box.min.z, before.min.z, 1e-9);
  release(from);
}

TEST_F(DragFaceTest, AltMovesTheFaceOppositeAsFarTheOtherWay) {
  const Box before = probe().box;
  drag(facePixel(kPlusX), facePixelAfter(kPlusX, -0.6), Qt::AltModifier);
  const double in = before.max.x - probe().box.max.x;
  EXPECT_NEAR(in, 0.6, 0.03);
  EXPECT_NEAR(probe().box.min.x - before.min.x, in, 1e-12);
  EXPECT_EQ(probe().box.min.y, before.min.y);
  EXPECT_EQ(probe().box.max.z, before.max.z);
}

TEST_F(DragFaceTest, EscapeBringsTheBoxBackAndLeavesNoStep) {
  const Box before = probe().box;
  const QPointF from = facePixel(kMinusY);
  const QPointF to = facePixelAfter(kMinusY, -1.0);
  press(from);
  move(to);
  EXPECT_FALSE(probe().box == before);
  key(Qt::Key_Escape);
  EXPECT_TRUE(probe().box == before);
  move(from);  // the button is still down, but nothing is held any more
  EXPECT_TRUE(probe().box == before);
  release(from);
  EXPECT_FALSE(document().canUndo());
  EXPECT_FALSE(document().previewing());
}

TEST_F(DragFaceTest, AClickEditsNothing) {
  press(facePixel(kPlusX));
  release(facePixel(kPlusX));
  EXPECT_FALSE(document().canUndo());
  EXPECT_FALSE(document().modified());
}

TEST_F(DragFaceTest, UndoDuringADragEndsIt) {
  const Box before = probe().box;
  const QPointF from = facePixel(kPlusX);
  press(from);
  move(facePixelAfter(kPlusX, -1.0));
  document().cancel();
  move(facePixelAfter(kPlusX, -2.0));
  release(facePixelAfter(kPlusX, -2.0));
  EXPECT_TRUE(probe().box == before);
}

TEST_F(DragFaceTest, ThePointerChangesOverAHandle) {
  move(facePixel(kPlusX));
  EXPECT_EQ(window_->viewport().cursor().shape(), Qt::OpenHandCursor);
  move(originPixel());
  EXPECT_EQ(window_->viewport().cursor().shape(), Qt::SizeAllCursor);
  move({3, 3});
  EXPECT_EQ(window_->viewport().cursor().shape(), Qt::ArrowCursor);
}

class DragRotatedFaceTest : public DragFaceTest {
 protected:
  LoadedScene scene() const override {
    return smallBuilding(
        {"probes.room.rotationDegrees=[0,25,0]", R"(probes.room.box={"min":[-2,0.2,-2],"max":[2,3,2]})"});
  }
};

TEST_F(DragRotatedFaceTest, LeavesTheOtherFacesWhereTheyAreInTheWorld) {
  const Probe before = probe();
  drag(facePixel(kPlusX), facePixelAfter(kPlusX, 0.5));
  const Probe after = probe();
  EXPECT_NEAR(after.box.size().x, before.box.size().x + 0.5, 0.03);
  for (const BoxFace& face : kBoxFaces) {
    if (face == kPlusX) continue;
    // The face's plane: how far its centre is along its own axis.
    const double was = glm::dot(faceCenterWorld(before, face), faceAxisWorld(before, face));
    const double is = glm::dot(faceCenterWorld(after, face), faceAxisWorld(after, face));
    EXPECT_NEAR(was, is, 1e-9) << faceName(face);
  }
}

}  // namespace
}  // namespace boxprobe
