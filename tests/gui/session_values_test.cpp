// Sessions of the window, event by event as a user has them, each against values/session_CASE.txt: after each event
// everything that changed.
#include <gtest/gtest.h>

#include <QMenu>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/gui/edit/view_state.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/axis_gizmo.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/picture_menu.h"
#include "app/gui/window/view_tools.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/handle_picking.h"
#include "tests/gui/session_record.h"

namespace boxprobe {
namespace {

/// On a wall, away from handles; and where the sky is.
const QPointF kWall{60.0, 60.0}, kOther{420.0, 250.0};

class SessionCameraTest : public SessionTest {
 protected:
  ViewCommands& views() { return window_->tools().views(); }

  void turnAndMove(const std::string& where) {
    struct Way {
      const char* name;
      Qt::MouseButton button;
      Qt::KeyboardModifiers modifiers;
    };
    const Way ways[] = {{"left", Qt::LeftButton, {}},
                        {"middle", Qt::MiddleButton, {}},
                        {"right", Qt::RightButton, {}},
                        {"Shift", Qt::LeftButton, Qt::ShiftModifier},
                        {"Ctrl", Qt::LeftButton, Qt::ControlModifier},
                        {"Alt", Qt::LeftButton, Qt::AltModifier},
                        {"Ctrl Shift", Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier}};
    for (const Way& way : ways) {
      dragWith(way.button, kWall, {37.0, 23.0}, way.modifiers);
      note(where + ", drag with " + way.name);
    }
    wheel({300.0, 130.0}, 120);
    note(where + ", wheel");
    wheel({90.0, 200.0}, -240);
    note(where + ", wheel back");
    wheel({90.0, 200.0}, 0, 120);
    note(where + ", wheel sideways");
  }
};

TEST_F(SessionCameraTest, EachWayToMoveIt) {
  turnAndMove("main");
  key(Qt::Key_Home);
  note("Home");
  // A hand is never quite still.
  move(kOther);
  press(kOther);
  move(kOther + QPointF(2.0, 3.0));
  note("3.6 pixels");
  move(kOther + QPointF(2.0, 3.5));
  note("4.03 pixels");
  move(kOther + QPointF(-1.0, -2.0));
  note("and back");
  release(kOther + QPointF(-1.0, -2.0));
  note("let go");
  press(kOther, {}, Qt::RightButton);
  wheel(kOther, 360);
  move(kOther + QPointF(0.0, 30.0));
  press(kOther, {}, Qt::LeftButton);
  move(kOther + QPointF(0.0, 60.0));
  release(kOther, {}, Qt::LeftButton);
  move(kOther + QPointF(0.0, 90.0));
  release(kOther, {}, Qt::RightButton);
  note("right, and left within");
  dragWith(Qt::LeftButton, kOther, {0.0, 400.0});
  note("down to the pole");
  dragWith(Qt::LeftButton, kOther, {0.0, -700.0});
  note("up to the pole");
  putCamera({3.0, 9.0, 14.0}, {1.0, 1.0, 0.5});
  note("from afar");
  turnAndMove("from afar");
  dragWith(Qt::LeftButton, {20.0, 20.0}, {25.0, -14.0});
  note("about the middle");
  for (const char* low : {"main", "low", "top", "corner"}) {
    choose(std::string("View > Camera > ") + low);
    note(low);
  }
  expectKept();
}

TEST_F(SessionCameraTest, AxesFramesAndSpots) {
  for (const char* axis : {"+X", "-X", "+Y", "-Y", "+Z", "-Z"}) {
    choose(std::string("View > Look along an axis > From ") + axis);
    note(axis);
    wheel({300.0, 130.0}, 120);
    dragWith(Qt::MiddleButton, kWall, {37.0, 23.0});
    note("wheel and moved");
    key(Qt::Key_F);
    note("F");
    dragWith(axis[0] == '+' ? Qt::LeftButton : Qt::RightButton, kWall, {37.0, 23.0});
    note("turned");
  }
  choose("View > Look along an axis > From +Y");
  key(Qt::Key_P);
  note("P from above");
  key(Qt::Key_F);
  note("F there");
  choose("View > Look along an axis > From -Z");
  choose("View > Walk at eye height");
  note("walks from an axis");
  choose("View > Walk at eye height");
  note("and no more");
  putCamera({9.0, 4.0, 12.0}, {0.0, 1.0, 0.0});
  choose("View > Walk at eye height");
  choose("View > Walk at eye height");
  note("walks outside");
  key(Qt::Key_F);
  note("F from outside");
  choose("View > Cut away what hides the probe's box");
  note("cut");
  key(Qt::Key_F);
  note("F with the cut");
  click(kOther);
  note("click with the cut");
  choose("View > Cut away what hides the probe's box");
  note("whole");
  window_->editor().selectProbes({0, 1});
  key(Qt::Key_F);
  note("F of both");
  choose("View > Look along an axis > From +X");
  note("both from +X");
  window_->editor().selectProbe({});
  key(Qt::Key_P);
  key(Qt::Key_F);
  note("F of nothing");
  choose("View > Look along an axis > From -Y");
  note("nothing from -Y");
  window_->viewState().selectObjects({"sphere 2"});
  key(Qt::Key_F);
  note("F of an object");
  window_->viewState().selectObjects({"sphere 2", "mirror", "no such object"});
  key(Qt::Key_Home);
  key(Qt::Key_F);
  note("F of objects");
  window_->editor().selectProbe(1);
  note("the other probe");
  const glm::dvec3 spot(1.1, 0.4, -2.2);
  views().lookAtSpot(spot, {4.1, 3.2, 1.7});
  note("a spot");
  views().lookAtSpot(spot, spot + glm::dvec3(0.0, 0.5, 0.0));
  note("from above");
  views().lookAtSpot(spot, spot);
  note("from itself");
  views().lookAtSpot(spot, spot + glm::dvec3(30.0, 10.0, 70.0));
  note("from afar");
  views().comeBack();
  note("back");
  views().comeBack();
  note("and again");
  auto* gizmo = window_->findChild<AxisGizmo*>();
  for (const BoxFace& face : kBoxFaces) {
    choose("View > Camera > corner");
    QTest::mouseMove(gizmo, gizmo->knob(face).toPoint());
    QTest::mouseClick(gizmo, face.positive ? Qt::LeftButton : Qt::RightButton, {}, gizmo->knob(face).toPoint());
    note(std::string("knob ") + faceName(face) + " at " + roundedText(gizmo->knob(face).x()) + " " +
         roundedText(gizmo->knob(face).y()));
    QTest::mouseClick(gizmo, Qt::LeftButton, {}, gizmo->knob(face).toPoint());
    note("knob");
  }
  QTest::mouseClick(gizmo, Qt::LeftButton, {}, {2, 84});
  note("beside the knobs");
  expectKept();
}

// A tick is of whole milliseconds, at most a hundred of them: whatever the machine's load, each step is so many times
// the pace.
TEST_F(SessionCameraTest, FlightKeepsItsPaceAndWay) {
  auto& controller = window_->viewport().cameraController();
  const glm::dvec3 eye(3.1, 2.2, 4.3), target(0.2, 1.4, -0.6), up(0.0, 1.0, 0.0);
  const glm::dvec3 forward = glm::normalize(target - eye), right = glm::normalize(glm::cross(forward, up));
  const auto level = [](const glm::dvec3& v) { return glm::normalize(glm::dvec3(v.x, 0.0, v.z)); };
  const double pace = std::clamp(0.16 * glm::length(window_->renderer().bounds().size()), 0.5, 20.0);
  // The wheel says how fast, and has its ends. Let go where it was pressed, the button would open a menu.
  const auto hold = [this] {
    press(kWall, {}, Qt::RightButton);
    move(kWall + QPointF(20.0, 0.0));
  };
  const auto letGo = [this] { release(kWall + QPointF(20.0, 0.0), {}, Qt::RightButton); };
  hold();
  wheel(kWall, 120 * 100);
  wheel(kWall, 120 * 2);
  wheel(kWall, -120 * 100);
  wheel(kWall, -120 * 2);
  wheel(kWall, 120 * 7);
  letGo();
  const double speed = pace * 0.05 * std::pow(1.2, 7.0);

  const auto fly = [&](const char* what, const std::vector<Qt::Key>& keys, bool fast, const glm::dvec3& way) {
    SCOPED_TRACE(what);
    putCamera(eye, target);
    std::vector<glm::dvec3> places = {window_->renderer().currentCamera().position};
    const auto watch = QObject::connect(&controller, &CameraController::moved,
                                        [&] { places.push_back(window_->renderer().currentCamera().position); });
    for (const Qt::Key each : keys) {
      QTest::keyPress(window_->windowHandle(), each, fast ? Qt::ShiftModifier : Qt::NoModifier);
    }
    const std::size_t first = places.size();  // from here on all of them are held
    EXPECT_TRUE(waitFor([&] { return places.size() >= first + 4; }));
    EXPECT_TRUE(controller.flying());
    for (const Qt::Key each : keys) QTest::keyRelease(window_->windowHandle(), each);
    QObject::disconnect(watch);
    EXPECT_FALSE(controller.flying());
    for (std::size_t i = first; i < places.size(); ++i) {
      glm::dvec3 step = places[i] - places[i - 1];
      if (controller.walking()) step.y = 0.0;
      const double ticks = 1000.0 * glm::length(step) / (speed * (fast ? 4.0 : 1.0));
      EXPECT_NEAR(ticks, std::round(ticks), 1e-6);
      EXPECT_GE(ticks, 0.5);
      EXPECT_LE(ticks, 100.5);
      EXPECT_NEAR(glm::length(glm::normalize(step) - way), 0.0, 1e-6);
    }
    const Camera now = window_->renderer().currentCamera();
    EXPECT_NEAR(glm::length(now.target - now.position - (target - eye)), 0.0, 1e-9) << "it does not turn";
  };
  fly("W", {Qt::Key_W}, false, forward);
  fly("S", {Qt::Key_S}, true, -forward);
  fly("A", {Qt::Key_A}, false, -right);
  fly("D and W", {Qt::Key_D, Qt::Key_W}, true, glm::normalize(forward + right));
  fly("S, A, D", {Qt::Key_S, Qt::Key_A, Qt::Key_D}, false, -forward);
  hold();
  fly("E", {Qt::Key_E}, false, up);
  fly("Q and D", {Qt::Key_Q, Qt::Key_D}, false, glm::normalize(right - up));
  letGo();
  keyDown(Qt::Key_W);
  keyDown(Qt::Key_S);
  EXPECT_TRUE(controller.flying());
  window_->setFocus();
  EXPECT_FALSE(controller.flying()) << "its keys go elsewhere";
  window_->viewport().setFocus();
  keyUp(Qt::Key_W);
  keyUp(Qt::Key_S);
  controller.setWalking(true);
  fly("W on foot", {Qt::Key_W}, false, level(forward));
  EXPECT_NEAR(window_->renderer().currentCamera().position.y, 1.6, 0.05);
  fly("A on foot", {Qt::Key_A}, false, -right);
  hold();
  fly("E and S on foot", {Qt::Key_E, Qt::Key_S}, false, -level(forward));
  letGo();
  controller.setWalking(false);
}

TEST_F(SessionCameraTest, CamerasOfTheScene) {
  key(Qt::Key_P);
  views().storeCamera(" main ");
  note("stored");
  views().storeCamera("  ");
  views().storeCamera("");
  note("stored without a name, twice");
  choose("View > Camera > main 2");
  note("main 2");
  views().renameCamera(4, " desk ");
  note("renamed");
  views().renameCamera(4, " desk");
  views().renameCamera(4, " ");
  note("to nothing");
  views().renameCamera(3, "low");
  views().renameCamera(9, "none");
  note("to another's");
  choose("View > Camera > low");
  choose("View > Camera > Move here > top");
  note("moved");
  views().updateCamera(9);
  note("a tenth");
  choose("View > Camera > Delete > low");
  note("deleted");
  views().deleteCamera(9);
  note("a tenth");
  choose("View > Reset view");
  note("first camera");
  for (int i = 0; i < 4; ++i) key(Qt::Key_Z, Qt::ControlModifier);
  note("undone");
  expectKept();
}

}  // namespace
}  // namespace boxprobe
