// The mouse beside the handles moves the camera and edits nothing.
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QMenuBar>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/gui/view/viewport.h"
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

TEST_F(CameraTest, DraggingTurnsAboutThePointLookedAt) {
  const Camera before = camera();
  drag(kBeside, kBeside + QPointF(70, 30));
  EXPECT_GT(glm::length(camera().position - before.position), 0.1);
  EXPECT_NEAR(glm::length(camera().target - before.target), 0.0, 1e-9);
  EXPECT_NEAR(distance(camera()), distance(before), 1e-9);
  EXPECT_TRUE(camera().up == before.up) << "the horizon must stay level";
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

TEST_F(CameraTest, TheWheelComesCloser) {
  const Camera before = camera();
  QWheelEvent event(kBeside, window_->viewport().mapToGlobal(kBeside.toPoint()), {}, {0, 120}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&window_->viewport(), &event);
  EXPECT_LT(distance(camera()), 0.95 * distance(before));
  EXPECT_GT(distance(camera()), 0.5 * distance(before));
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
