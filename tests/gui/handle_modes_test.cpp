// The handles' modes: what each lets be taken hold of, and what dragging it changes.
#include <gmock/gmock.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <glm/geometric.hpp>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/view_tools.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class HandleModesTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    window_->probeWidget().setMode(HandleMode::Box);
  }
  void TearDown() override { window_->probeWidget().setMode(HandleMode::Box); }

  QPointF at(const Handle& handle) const {
    const auto grip = handleGripWorld(probe(), handle, window_->viewport().view());
    return pixelOf(grip.back());
  }
  /// The grip's pixel once it is `metres` further along its axis.
  QPointF after(const Handle& handle, double metres) const {
    const auto grip = handleGripWorld(probe(), handle, window_->viewport().view());
    return pixelOf(grip.back() + metres * handleAxisWorld(probe(), handle));
  }
  static constexpr BoxFace kPlusX{0, true};
  static constexpr Handle kInfluence{HandleKind::Influence, 0, kPlusX}, kBlend{HandleKind::Blend, 0, {0, false}};
};

TEST_F(HandleModesTest, KeysChooseTheModeAndTheMenuShowsIt) {
  const std::pair<Qt::Key, HandleMode> modes[] = {{Qt::Key_2, HandleMode::Influence},
                                                  {Qt::Key_3, HandleMode::Origin},
                                                  {Qt::Key_4, HandleMode::Place},
                                                  {Qt::Key_1, HandleMode::Box}};
  for (const auto& [pressed, mode] : modes) {
    key(pressed);
    EXPECT_EQ(window_->probeWidget().mode(), mode);
    const QString name = QString("handles%1").arg(static_cast<int>(mode) + 1);
    EXPECT_TRUE(window_->findChild<QAction*>(name)->isChecked());
  }
}

TEST_F(HandleModesTest, InfluenceAndBlendAreUniformsAndOneStepEach) {
  key(Qt::Key_2);
  waitUntilIdle();
  move(at(kInfluence));
  waitUntilIdle();
  const Counters before = counters();
  const Probe start = probe();
  drag(at(kInfluence), after(kInfluence, 0.8));
  ASSERT_TRUE(probe().influence);
  EXPECT_NEAR(probe().influence->max.x, start.box.max.x + 0.8, 0.04);
  EXPECT_EQ(probe().box, start.box);
  EXPECT_EQ(document().undoLabel(), "Move influence face +X of room");
  drag(at(kBlend), after(kBlend, -0.3));
  EXPECT_NEAR(probe().blendDistance.min.x, start.blendDistance.min.x + 0.3, 0.04);
  EXPECT_EQ(document().undoLabel(), "Set blend distance -X of room");
  waitUntilIdle();
  EXPECT_EQ(counters().facesCaptured, before.facesCaptured);
  EXPECT_EQ(counters().levelsFiltered, before.levelsFiltered);
  EXPECT_EQ(counters().programsCompiled, before.programsCompiled);
  document().undo();
  document().undo();
  EXPECT_EQ(probe(), start);
}

TEST_F(HandleModesTest, FacesOfTheBoxCannotBeTakenInOtherModes) {
  const QPointF face = facePixel(kPlusX) + QPointF(0.0, 0.0);
  key(Qt::Key_3);
  const Box before = probe().box;
  drag(face, face + QPointF(40, 0));
  EXPECT_EQ(probe().box, before);
}

TEST_F(HandleModesTest, AnArrowMovesTheOriginAlongTheWorldsAxis) {
  key(Qt::Key_3);
  const Probe start = probe();
  const Handle up{HandleKind::OriginAxis, 0, {1, true}};
  drag(at(up), after(up, 0.4));
  EXPECT_NEAR(probe().origin.y, start.origin.y + 0.4, 0.03);
  EXPECT_EQ(probe().origin.x, start.origin.x);
  EXPECT_EQ(probe().box, start.box);
}

TEST_F(HandleModesTest, TheWholeProbeMovesAndTurnsAndEscapeRestoresIt) {
  key(Qt::Key_4);
  const Probe start = probe();
  const Handle along{HandleKind::Move, 0, kPlusX};
  drag(at(along), after(along, 0.7));
  const glm::dvec3 by = probe().origin - start.origin;
  EXPECT_NEAR(by.x, 0.7, 0.04);
  EXPECT_NEAR(glm::length(probe().box.min - start.box.min - by), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(probe().box.max - start.box.max - by), 0.0, 1e-12);
  EXPECT_EQ(document().undoLabel(), "Move room");
  document().undo();

  // From above: seen almost from its edge, a ring turns by its tangent instead.
  const glm::dvec3 middle = probe().box.center();
  window_->tools().views().lookAtSpot(middle, middle + glm::dvec3(4.0, 8.0, 6.0));
  waitUntilIdle();
  const Handle yaw{HandleKind::Turn, 0, {1, true}};
  const auto ring = handleGripWorld(probe(), yaw, window_->viewport().view());
  // Taken at an eighth of the ring, which no arrow crosses, and led along it.
  press(pixelOf(ring[6]));
  for (std::size_t i = 7; i <= 12; ++i) move(pixelOf(ring[i]));
  EXPECT_NEAR(std::abs(probe().rotationDegrees.y), 45.0, 1.0);
  EXPECT_EQ(probe().rotationDegrees.x, 0.0);
  key(Qt::Key_Escape);
  EXPECT_EQ(probe(), start);
  release(pixelOf(ring[12]));
  EXPECT_EQ(probe(), start);
  EXPECT_FALSE(document().canUndo());
}

TEST_F(HandleModesTest, CtrlLaysAFaceOnTheWallUnderThePointer) {
  // Where the wall behind the box is, by a ray of the scene's own.
  const Handle back{HandleKind::Face, 0, {2, false}};
  const double was = probe().box.min.z;
  const ViewProjection view = window_->viewport().view();
  // The far wall of the building, where the picture shows it beside the box.
  std::optional<QPointF> wall;
  SceneSurfaces surfaces(document());
  surfaces.setModels(window_->models());
  double z = 0.0;
  for (int x = 40; x < 700 && !wall; x += 20) {
    for (int y = 60; y < 500 && !wall; y += 20) {
      const Ray ray = view.ray({x, y});
      const auto hit = surfaces.rays()->first(ray.origin, ray.direction);
      if (!hit || hit->normalWorld.z < 0.99) continue;
      z = (ray.origin + hit->distance * ray.direction).z;
      if (z < was - 0.2) wall = QPointF(x, y);
    }
  }
  ASSERT_TRUE(wall) << "the first camera sees no wall behind the box";
  drag(at(back), *wall, Qt::ControlModifier);
  EXPECT_NEAR(probe().box.min.z, z, 1e-9);
  EXPECT_LT(probe().box.min.z, was - 0.1);
}

TEST_F(HandleModesTest, ArrowKeysNudgeInOneStep) {
  key(Qt::Key_3);
  move({3, 3});
  const glm::dvec3 before = probe().origin;
  keyDown(Qt::Key_PageUp);
  keyDown(Qt::Key_PageUp);
  keyUp(Qt::Key_PageUp);
  EXPECT_NEAR(probe().origin.y, before.y + 0.2, 1e-12);
  EXPECT_FALSE(document().previewing());
  document().undo();
  EXPECT_EQ(probe().origin, before);
  EXPECT_FALSE(document().canUndo());
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(glm::length(probe().origin - before), 0.01, 1e-12);
  document().undo();
  key(Qt::Key_1);
  move(facePixel(kPlusX));
  const double face = probe().box.max.x;
  const bool left = window_->viewport().view().right().x < 0.0;
  key(left ? Qt::Key_Left : Qt::Key_Right);
  EXPECT_NEAR(probe().box.max.x, face + 0.1, 1e-9);
}

TEST_F(HandleModesTest, AClickShowsTheObjectUnderThePointerInThePanels) {
  const Ray down{{0.0, 1.5, 2.0}, {0.0, -1.0, 0.0}};
  SceneSurfaces surfaces(document());
  surfaces.setModels(window_->models());
  const auto floor = surfaces.meet(down);
  ASSERT_TRUE(floor);
  const QPointF at = pixelOf(*floor);
  const auto seen = surfaces.objectAt(window_->viewport().view().ray({at.x(), at.y()}));
  ASSERT_TRUE(seen);
  press(at);
  release(at);
  EXPECT_EQ(window_->findChild<QComboBox*>("object")->currentText().toStdString(), seen->node);
  EXPECT_EQ(window_->findChild<QComboBox*>("material")->currentText().toStdString(), seen->material);
  EXPECT_FALSE(document().canUndo()) << "looking at something edits nothing";
  const auto menu = window_->tools().pictureMenu().menuAt(at);
  QStringList texts;
  for (const QAction* action : menu->actions()) texts += action->text();
  EXPECT_TRUE(texts.contains("Leave out of the capture of room")) << texts.join(", ").toStdString();
  for (QAction* action : menu->actions()) {
    if (action->text() == "Leave out of the capture of room") action->trigger();
  }
  EXPECT_THAT(probe().hides, testing::Contains(seen->node));
  document().undo();
  EXPECT_FALSE(document().canUndo());
}

TEST_F(HandleModesTest, AQuestionMarkShowsTheKeys) {
  key(Qt::Key_Question, Qt::ShiftModifier);
  auto* keys = window_->findChild<QLabel*>("keys");
  ASSERT_NE(keys, nullptr);
  EXPECT_TRUE(keys->isVisible());
  EXPECT_TRUE(keys->text().contains("Ctrl+Y"));
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) window_->grab().save(QString(folder) + "/keys.png");
  key(Qt::Key_Question, Qt::ShiftModifier);
  EXPECT_FALSE(keys->isVisible());
}

TEST_F(HandleModesTest, EachModeDrawsItsHandles) {
  QImage last;
  for (const Qt::Key mode : {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4}) {
    key(mode);
    waitUntilIdle();
    const QImage shown = shownPicture(window_->viewport());
    if (!last.isNull()) {
      EXPECT_GT(differingShare(last, shown), 0.0005);
    }
    last = shown;
    if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
      window_->grab().save(QString("%1/handles-%2.png").arg(folder).arg(static_cast<int>(mode - Qt::Key_0)));
    }
  }
}

}  // namespace
}  // namespace boxprobe
