// Whole probes: add, duplicate, delete, rename, select; each undone in one step.
#include "app/gui/panels/probe_commands.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QStatusBar>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <glm/geometric.hpp>

#include "app/gui/edit/probe_copies.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/panels/outliner.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/probe_clipboard.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/handle_drag.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class ProbeCommandsTest : public WindowTest {
 protected:
  QTreeView* tree() const { return window_->findChild<Outliner*>()->tree(); }
  QModelIndex row(std::size_t probe) const { return window_->findChild<Outliner*>()->model().probe(probe); }
  QString shownName(std::size_t probe) const { return row(probe).data().toString(); }
  void click(const char* button) {
    QTest::mouseClick(window_->findChild<QToolButton*>(button), Qt::LeftButton);
    waitUntilIdle();
  }
  /// F2, the name, Enter: in the list itself.
  void rename(std::size_t probe, const QString& name) {
    tree()->setFocus();
    tree()->setCurrentIndex(row(probe));
    tree()->edit(row(probe));
    auto* editor = tree()->viewport()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, name);
    QTest::keyClick(editor, Qt::Key_Return);
    // The tree takes the text over in the next turn, and hands it on in the one after.
    for (int turn = 0; turn < 2; ++turn) QCoreApplication::processEvents();
  }
  std::size_t count() const { return window_->document().scene().probes.size(); }
};

TEST_F(ProbeCommandsTest, AddFitsAProbeToTheSceneWhereTheCameraLooks) {
  click("Add");
  ASSERT_EQ(count(), 2u);
  const Probe& added = probe(1);
  const Box bounds = window_->renderer().bounds();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(added.box.min[axis], bounds.min[axis]);
    EXPECT_GE(added.box.max[axis], bounds.max[axis]);
  }
  const Camera camera = window_->renderer().currentCamera();
  EXPECT_EQ(added.origin.x, camera.target.x);
  EXPECT_EQ(document().selectedProbe(), 1u);
  EXPECT_EQ(tree()->currentIndex(), row(1));
  document().undo();
  EXPECT_EQ(count(), 1u);
  EXPECT_FALSE(row(1).isValid());
  EXPECT_FALSE(document().canUndo());
}

// The target lies below the floor, which is at 0; before it nothing stands in the way.
TEST_F(ProbeCommandsTest, AnAddedProbeStandsInTheOpen) {
  Camera camera = window_->renderer().currentCamera();
  camera.target = camera.position + 3.0 * (glm::dvec3(camera.target.x, -2.0, camera.target.z) - camera.position);
  const glm::dvec3& target = camera.target;
  window_->renderer().renderer()->GetActiveCamera()->SetFocalPoint(target.x, target.y, target.z);
  window_->findChild<ProbeCommands*>()->addProbe();
  const glm::dvec3 way = probe(1).origin - camera.position, along = glm::normalize(camera.target - camera.position);
  EXPECT_NEAR(glm::dot(way, along), glm::length(way), 1e-9) << "on the way to the target";
  EXPECT_NEAR(probe(1).origin.y, 0.5 * camera.position.y, 1e-4) << "half way to the floor";
}

TEST_F(ProbeCommandsTest, DuplicateCopiesEverythingButTheNameALittleAside) {
  click("Duplicate");
  ASSERT_EQ(count(), 2u);
  Probe copy = probe(1);
  EXPECT_EQ(copy.name, "room 2");
  copy.name = "room";
  const double aside = 0.1 * probe(0).box.size().x;
  EXPECT_NEAR(copy.origin.x - probe(0).origin.x, aside, 1e-12);
  EXPECT_TRUE(movedProbe(probe(0), copy.origin - probe(0).origin) == copy);
  EXPECT_EQ(document().selectedProbe(), 1u);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(count(), 1u);
  EXPECT_EQ(document().selectedProbe(), 0u) << "something stays selected";
  key(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(count(), 2u);
  EXPECT_EQ(document().selectedProbe(), 1u) << "what comes back is selected";
}

TEST_F(ProbeCommandsTest, CopyAndPasteGoThroughTheTextOfASceneFile) {
  window_->viewport().setFocus();
  key(Qt::Key_C, Qt::ControlModifier);
  const std::string text = QApplication::clipboard()->text().toStdString();
  ASSERT_EQ(probesFromText(text).size(), 1u);
  EXPECT_TRUE(probesFromText(text).front() == probe(0));
  key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(count(), 2u);
  EXPECT_EQ(probe(1).name, "room 2");
  EXPECT_GT(probe(1).box.min.x, probe(0).box.min.x) << "not exactly on what it was copied from";
  EXPECT_EQ(document().selectedProbe(), 1u);
  EXPECT_EQ(document().undoLabel(), "Paste room 2");
  document().undo();
  // One probe alone, and a list, as they stand in a file.
  const std::string one = R"({"name": "hall", "origin": [0, 1, 0], "box": {"min": [-1, 0, -1], "max": [1, 2, 1]}})";
  for (const std::string& pasted : {one, "[" + one + "]", "{\"probes\": [" + one + "]}"}) {
    EXPECT_EQ(probesFromText(pasted).front().name, "hall") << pasted;
  }
}

// The first copy of a place that is taken goes one step, the next two; one that stands apart stays.
TEST(ProbeCopies, StandBesideOneAnotherAndKeepTheRest) {
  Probe hall;
  hall.name = "hall";
  hall.box = {{-1.0, 0.25, -3.0}, {4.0, 2.0, 0.5}};
  hall.influence = Box{{-0.5, 0.5, -2.0}, {3.0, 1.5, 0.25}};
  hall.origin = {1.25, 1.0, -0.75};
  hall.rotationDegrees = {10.0, 35.0, -5.0};
  Scene scene;
  scene.probes = {hall};
  ProbeCopies copies(scene);
  constexpr int kCopies = 10000;
  for (int i = 1; i <= kCopies; ++i) {
    Probe copy = copies.add(hall);
    ASSERT_EQ(copy.name, "hall " + std::to_string(i + 1));
    const glm::dvec3 by = copy.origin - hall.origin;
    ASSERT_NEAR(glm::length(by), 0.1 * 5.0 * i, 1e-7);
    copy.name = "hall";
    const Probe moved = movedProbe(hall, by);
    ASSERT_LT(glm::length(copy.box.max - moved.box.max) + glm::length(copy.influence->min - moved.influence->min),
              1e-7);
  }
  // In the same place with another influence, or none.
  Probe other = hall;
  other.influence = Box{{-0.75, 0.25, -1.0}, {2.0, 1.75, 0.0}};
  Probe copy = copies.add(other);
  const Probe moved = movedProbe(other, copy.origin - other.origin);
  EXPECT_LT(glm::length(copy.influence->min - moved.influence->min), 1e-12);
  EXPECT_LT(glm::length(copy.influence->max - moved.influence->max), 1e-12);
  other.influence.reset();
  EXPECT_FALSE(copies.add(other).influence);
  EXPECT_TRUE(copies.add(hall).influence);
  Probe apart = movedProbe(hall, {0.0, 20.0, 0.0});
  apart.name = "apart";
  EXPECT_TRUE(copies.add(apart) == apart);
}

TEST_F(ProbeCommandsTest, AHundredArePastedAsOneStepAndAllAreShown) {
  QString text = "[";
  for (int i = 0; i < 100; ++i) {
    text += QString(R"(%1{"name": "p%2", "origin": [%2, 1, 0], "box": {"min": [%3, 0, -1], "max": [%4, 2, 1.5]}})")
                .arg(i > 0 ? ", " : "")
                .arg(i)
                .arg(i - 1)
                .arg(i + 2);
  }
  QApplication::clipboard()->setText(text + "]");
  window_->viewport().setFocus();
  key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(count(), 101u);
  EXPECT_EQ(document().undoLabel(), "Paste 100 probes");
  EXPECT_TRUE(row(100).isValid());
  EXPECT_EQ(probe(100).name, "p99");
  key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(count(), 201u);
  EXPECT_EQ(probe(200).name, "p99 2");
  EXPECT_GT(probe(200).origin.x, probe(100).origin.x);
  document().undo();
  document().undo();
  EXPECT_EQ(count(), 1u);
}

TEST_F(ProbeCommandsTest, PastedTextThatIsNoProbeIsOneLineAndChangesNothing) {
  const Scene before = document().scene();
  window_->viewport().setFocus();
  const std::string wrong[] = {
      "",       "Dear colleague,",
      "[1, 2]", "{}",
      "[]",     R"([{"name": "x", "origin": [0, 1, 0], "box": {"min": [3, 0, 0], "max": [1, 1, 1]}}])"};
  for (const std::string& text : wrong) {
    SCOPED_TRACE(text);
    window_->statusBar()->clearMessage();
    QApplication::clipboard()->setText(QString::fromStdString(text));
    key(Qt::Key_V, Qt::ControlModifier);
    EXPECT_TRUE(document().scene() == before);
    const QString said = window_->statusBar()->currentMessage();
    EXPECT_TRUE(said.startsWith("No probe to paste: ")) << said.toStdString();
    EXPECT_FALSE(said.contains('\n'));
  }
  EXPECT_FALSE(document().canUndo());
}

TEST_F(ProbeCommandsTest, DeleteTakesTheSelectedOneAndUndoBringsItBack) {
  click("Duplicate");
  tree()->setCurrentIndex(row(0));
  click("Delete");
  ASSERT_EQ(count(), 1u);
  EXPECT_EQ(probe(0).name, "room 2");
  EXPECT_EQ(document().selectedProbe(), 0u);
  document().undo();
  ASSERT_EQ(count(), 2u);
  EXPECT_EQ(probe(0).name, "room");
}

TEST_F(ProbeCommandsTest, TheLastProbeCanGoAndThePanelSaysSo) {
  tree()->setFocus();
  key(Qt::Key_Delete);
  waitUntilIdle();
  EXPECT_EQ(count(), 0u);
  EXPECT_FALSE(window_->findChild<QWidget*>("boxMin")->isEnabled());
  document().undo();
  EXPECT_EQ(count(), 1u);
}

TEST_F(ProbeCommandsTest, RenameInPlaceIsOneStepAndKeepsTheSelection) {
  rename(0, "hall");
  EXPECT_EQ(probe(0).name, "hall");
  EXPECT_EQ(document().selectedProbe(), 0u);
  EXPECT_EQ(document().undoLabel(), "Rename room to hall");
  document().undo();
  EXPECT_EQ(probe(0).name, "room");
  EXPECT_EQ(shownName(0), "room");
}

TEST_F(ProbeCommandsTest, ANameTwiceOrNoneIsRefusedInOneLine) {
  click("Duplicate");
  rename(1, "room");
  EXPECT_EQ(probe(1).name, "room 2");
  EXPECT_EQ(shownName(1), "room 2");
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains("room")) << "the status bar must say why";
  rename(1, "  ");
  EXPECT_EQ(probe(1).name, "room 2");
  document().undo();
  EXPECT_FALSE(document().canUndo());
}

TEST_F(ProbeCommandsTest, ClickingAnotherProbesOriginSelectsItAndEditsNothing) {
  click("Duplicate");
  window_->editor().commitProbe("Set origin", [](Probe& edited) { edited.origin.x += 1.5; });
  waitUntilIdle();
  ASSERT_EQ(document().selectedProbe(), 1u);
  const std::string last = document().undoLabel();
  const QPointF at = originPixel(0);
  press(at);
  move(at + QPointF(15, 0));
  release(at + QPointF(15, 0));
  EXPECT_EQ(document().selectedProbe(), 0u);
  EXPECT_EQ(tree()->currentIndex(), row(0));
  EXPECT_EQ(document().undoLabel(), last);
}

}  // namespace
}  // namespace boxprobe
