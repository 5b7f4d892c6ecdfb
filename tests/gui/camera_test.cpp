// The mouse beside the handles moves the camera and edits nothing.
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/gui/handles/scene_surfaces.h"
#include "app/gui/view/axis_gizmo.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/view_tools.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class CameraTest : public WindowTest {
 protected:
  Camera camera() const { return window_->renderer().currentCamera(); }
  /// Away from every handle.
  const QPointF kBeside{40, 40};
};

double distance(const Camera& camera) {
  return glm::length(camera.position - camera.target);
}

TEST_F(CameraTest, DraggingTurnsAboutThePointUnderThePointer) {
  const Camera before = camera();
  SceneSurfaces surfaces(document());
  surfaces.setModels(window_->models());
  const auto pointed = surfaces.meet(window_->viewport().view().ray({kBeside.x(), kBeside.y()}));
  ASSERT_TRUE(pointed) << "a wall is there";
  drag(kBeside, kBeside + QPointF(70, 30));
  EXPECT_GT(glm::length(camera().position - before.position), 0.1);
  EXPECT_NEAR(glm::length(camera().position - *pointed), glm::length(before.position - *pointed), 1e-9);
  EXPECT_NEAR(distance(camera()), distance(before), 1e-9);
  EXPECT_TRUE(camera().up == before.up) << "the horizon must stay level";
  EXPECT_LT(std::hypot(pixelOf(*pointed).x() - kBeside.x(), pixelOf(*pointed).y() - kBeside.y()), 1.5)
      << "the point keeps its place";
  EXPECT_FALSE(document().modified());
}

TEST_F(CameraTest, DoesNotTurnOverThePole) {
  drag(kBeside, kBeside + QPointF(0, 500));
  const glm::dvec3 view = glm::normalize(camera().target - camera().position);
  EXPECT_GT(glm::length(glm::cross(view, camera().up)), 0.01);
  EXPECT_LT(view.y, 0.0) << "dragging down must end looking down";
}

TEST_F(CameraTest, ShiftMovesWithoutTurning) {
  const Camera before = camera();
  const QPointF target = pixelOf(before.target);
  drag(kBeside, kBeside + QPointF(50, -20), Qt::ShiftModifier);
  EXPECT_NEAR(glm::length((camera().target - camera().position) - (before.target - before.position)), 0.0, 1e-9);
  // What was looked at follows the pointer.
  const QPointF now = pixelOf(before.target);
  EXPECT_NEAR(now.x() - target.x(), 50, 0.5);
  EXPECT_NEAR(now.y() - target.y(), -20, 0.5);
}

TEST_F(CameraTest, TheWheelComesCloserToThePointUnderThePointer) {
  SceneSurfaces surfaces(document());
  surfaces.setModels(window_->models());
  // Far enough for a notch of the wheel to be a share of the way, and not the least step.
  const QPointF at(0.5 * window_->viewport().width(), 0.42 * window_->viewport().height());
  const auto pointed = surfaces.meet(window_->viewport().view().ray({at.x(), at.y()}));
  ASSERT_TRUE(pointed);
  const glm::dvec3 before = camera().position;
  QWheelEvent event(at, window_->viewport().mapToGlobal(at.toPoint()), {}, {0, 120}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&window_->viewport(), &event);
  EXPECT_NEAR(glm::length(camera().position - *pointed), glm::length(before - *pointed) / 1.12, 1e-9);
  EXPECT_LT(std::hypot(pixelOf(*pointed).x() - at.x(), pixelOf(*pointed).y() - at.y()), 0.1);
  // It does not stall before the wall.
  for (int i = 0; i < 120; ++i) QCoreApplication::sendEvent(&window_->viewport(), &event);
  EXPECT_GT(glm::dot(camera().position - *pointed, *pointed - before), 0.0) << "the wall was gone through";
}

// However far it goes in or out, it still looks somewhere, and turns.
TEST_F(CameraTest, ZoomingWithoutEndKeepsADirection) {
  const glm::dvec3 was = glm::normalize(camera().target - camera().position);
  const auto soundAfter = [&](double pixels, const char* what) {
    for (int i = 0; i < 20; ++i) drag({400, 400}, {400, 400 + pixels}, Qt::ControlModifier, 2);
    const Camera now = camera();
    const glm::dvec3 is = glm::normalize(now.target - now.position);
    EXPECT_GT(glm::dot(is, was), 0.999) << what;
    EXPECT_LT(distance(now), 1.0e15) << what;
    const auto pixel = window_->viewport().view().pixel(now.position + is);
    ASSERT_TRUE(pixel) << what;
    EXPECT_NEAR(pixel->x, 0.5 * window_->viewport().width(), 1.0) << what;
  };
  soundAfter(-390.0, "in");
  soundAfter(390.0, "out");
  drag({400, 400}, {460, 400});
  const Camera turned = camera();
  EXPECT_LT(glm::dot(glm::normalize(turned.target - turned.position), was), 0.999);
}

TEST_F(CameraTest, TheRightButtonLooksAroundFromWhereOneStands) {
  const Camera before = camera();
  press(kBeside, {}, Qt::RightButton);
  move(kBeside + QPointF(60, 0));
  release(kBeside + QPointF(60, 0), {}, Qt::RightButton);
  EXPECT_NEAR(glm::length(camera().position - before.position), 0.0, 1e-9);
  const glm::dvec3 was = glm::normalize(before.target - before.position);
  const glm::dvec3 is = glm::normalize(camera().target - camera().position);
  const glm::dvec3 right = glm::cross(was, before.up);
  EXPECT_GT(glm::dot(is, right), 0.1) << "to the right";
}

TEST_F(CameraTest, LettersFlyUntilTheyAreLetGo) {
  const Camera before = camera();
  const glm::dvec3 ahead = glm::normalize(before.target - before.position);
  keyDown(Qt::Key_W);
  EXPECT_TRUE(waitFor([&] { return glm::dot(camera().position - before.position, ahead) > 0.05; }));
  keyUp(Qt::Key_W);
  QCoreApplication::processEvents();
  const Camera stopped = camera();
  QTest::qWait(60);
  EXPECT_TRUE(camera().position == stopped.position);
  EXPECT_FALSE(window_->viewport().cameraController().flying());
  EXPECT_FALSE(document().modified());
}

TEST_F(CameraTest, WalkingKeepsTheEyesOverTheFloor) {
  key(Qt::Key_P);  // inside
  key(Qt::Key_G);
  EXPECT_NEAR(camera().position.y, 1.6, 0.02);
  const glm::dvec3 before = camera().position;
  keyDown(Qt::Key_S);
  EXPECT_TRUE(waitFor([&] { return glm::length(camera().position - before) > 0.05; }));
  keyUp(Qt::Key_S);
  EXPECT_NEAR(camera().position.y, 1.6, 0.02);
  key(Qt::Key_G);
  EXPECT_FALSE(window_->viewport().cameraController().walking());
}

TEST_F(CameraTest, FramesTheSelectionAndLooksFromTheProbe) {
  key(Qt::Key_F);
  EXPECT_NEAR(glm::length(camera().target - probe().box.center()), 0.0, 1e-9);
  for (const BoxFace& face : kBoxFaces) {
    const QPointF at = facePixel(face);
    EXPECT_TRUE(window_->viewport().rect().contains(at.toPoint())) << faceName(face);
  }
  key(Qt::Key_P);
  EXPECT_NEAR(glm::length(camera().position - probe().origin), 0.0, 1e-9);
}

TEST_F(CameraTest, AxisViewsAreParallelAndTurningLeavesThem) {
  key(Qt::Key_Y, Qt::AltModifier);
  EXPECT_GT(camera().parallelHeight, 0.0);
  const glm::dvec3 down = glm::normalize(camera().target - camera().position);
  EXPECT_NEAR(down.y, -1.0, 1e-12);
  auto* gizmo = window_->findChild<AxisGizmo*>();
  QTest::mouseClick(gizmo, Qt::LeftButton, {}, gizmo->knob({2, true}).toPoint());
  waitUntilIdle();
  EXPECT_NEAR(glm::length(camera().target - camera().position), camera().position.z - camera().target.z, 1e-9);
  drag(kBeside, kBeside + QPointF(40, 20));
  EXPECT_EQ(camera().parallelHeight, 0.0) << "turning goes back to perspective";
  EXPECT_NEAR(camera().up.y, 1.0, 1e-12);
}

TEST_F(CameraTest, StoredRenamedMovedAndDeletedCamerasAreStepsOfTheScene) {
  const std::size_t count = document().scene().cameras.size();
  key(Qt::Key_P);
  const Camera here = camera();
  window_->tools().views().storeCamera("main");
  ASSERT_EQ(document().scene().cameras.size(), count + 1);
  EXPECT_EQ(document().scene().cameras.back().name, "main 2") << "the name was taken";
  EXPECT_NEAR(glm::length(document().scene().cameras.back().position - here.position), 0.0, 1e-9);
  window_->tools().views().renameCamera(static_cast<int>(count), "desk");
  EXPECT_EQ(document().scene().cameras.back().name, "desk");
  const QList<QAction*> offered = window_->findChild<QMenu*>("cameras")->actions();
  EXPECT_TRUE(std::any_of(offered.begin(), offered.end(), [](const QAction* a) { return a->text().contains("desk"); }));
  window_->tools().views().renameCamera(static_cast<int>(count), "main");
  EXPECT_EQ(document().scene().cameras.back().name, "desk");
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains("main")) << "the status bar must say why";
  key(Qt::Key_Home);
  window_->tools().views().updateCamera(static_cast<int>(count));
  EXPECT_NEAR(glm::length(document().scene().cameras.back().position - camera().position), 0.0, 1e-9);
  window_->tools().views().deleteCamera(static_cast<int>(count));
  EXPECT_EQ(document().scene().cameras.size(), count);
  for (int i = 0; i < 4; ++i) document().undo();
  EXPECT_FALSE(document().canUndo());
  EXPECT_EQ(document().scene().cameras.size(), count);
}

TEST_F(CameraTest, PresetsAndResetComeFromTheScene) {
  const Camera before = camera();
  key(Qt::Key_2, Qt::ControlModifier);
  const Camera& second = document().scene().cameras.at(1);
  EXPECT_NEAR(glm::length(camera().position - second.position), 0.0, 1e-12);
  EXPECT_NEAR(camera().verticalFovDegrees, second.verticalFovDegrees, 1e-12);
  key(Qt::Key_Home);
  EXPECT_NEAR(glm::length(camera().position - before.position), 0.0, 1e-12);
}

}  // namespace
}  // namespace boxprobe
