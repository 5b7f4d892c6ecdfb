// The outliner, and what it shows and hides in the picture: by clicks on its rows, eyes and locks, and by keys. What
// the scene file has and what captures see stays as it is.
#include "app/gui/panels/outliner.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QScrollBar>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>
#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <set>
#include <utility>
#include <vector>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/handles/scene_surfaces.h"
#include "app/gui/panels/light_panel.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/window/view_tools.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/handle_drag.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

using Kind = OutlinerModel::Kind;
using Part = ViewState::Part;

class OutlinerTest : public WindowTest {
 protected:
  void TearDown() override {
    window_->viewState().forget();
    window_->viewState().setCutaway(false);
    window_->findChild<QLineEdit*>("outlinerFilter")->clear();
  }
  Outliner& outliner() const { return *window_->findChild<Outliner*>(); }
  QTreeView* tree() const { return outliner().tree(); }
  QModelIndex probeRow(std::size_t place) const { return outliner().model().probe(place); }
  /// Its group is opened, as a user does.
  QModelIndex objectRow(const std::string& node) const {
    const QModelIndex row = outliner().model().object(node);
    if (!tree()->isExpanded(row.parent())) tree()->expand(row.parent());
    return row;
  }
  void click(const QModelIndex& row, int column = OutlinerModel::kName, Qt::KeyboardModifiers modifiers = {}) {
    ASSERT_TRUE(row.isValid());
    tree()->scrollTo(row);
    QTest::mouseClick(tree()->viewport(), Qt::LeftButton, modifiers,
                      tree()->visualRect(row.siblingAtColumn(column)).center());
    waitUntilIdle();
  }
  void addProbe(const std::string& name, const glm::dvec3& by) {
    window_->editor().commit("Add", [&](Scene& scene) {
      Probe copy = movedProbe(scene.probes.front(), by);
      copy.name = name;
      scene.probes.push_back(copy);
    });
    waitUntilIdle();
  }
  QImage picture() {
    waitUntilIdle();
    return shownPicture(window_->viewport());
  }
  void keep(const char* name) {
    waitUntilIdle();
    if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
      window_->grab().save(QString("%1/%2.png").arg(folder, name));
    }
  }
  SceneRenderer& renderer() { return const_cast<SceneRenderer&>(window_->renderer()); }
  void look(const glm::dvec3& from, const glm::dvec3& at) {
    Camera camera = renderer().currentCamera();
    camera.position = from;
    camera.target = at;
    renderer().applyCamera(camera);
    emit window_->viewport().cameraMoved();
    waitUntilIdle();
  }
  /// Of all objects, as somebody else would find it.
  std::string firstAt(const glm::dvec3& pointWorld) {
    SceneSurfaces whole(document());
    whole.setModels(window_->models());
    const QPointF at = pixelOf(pointWorld);
    const auto object = whole.objectAt(window_->viewport().view().ray({at.x(), at.y()}));
    return object ? object->node : std::string();
  }
};

TEST_F(OutlinerTest, ARowSelectsItsProbeAndAProbeItsRow) {
  addProbe("second", {0.9, 0.3, 0.4});
  click(probeRow(0));
  EXPECT_EQ(document().selectedProbe(), 0u);
  click(probeRow(1));
  EXPECT_EQ(document().selectedProbe(), 1u);
  const BoxFace top{1, true};
  const auto handle = window_->probeWidget().probeAt(pixelOf(faceCenterWorld(probe(1), top)));
  EXPECT_EQ(handle, 1u) << "its handles are shown";
  EXPECT_NE(window_->probeWidget().probeAt(pixelOf(faceCenterWorld(probe(0), top))), std::optional<std::size_t>(0u));
  const QPointF at = originPixel(0);
  move(at);
  press(at);
  release(at);
  EXPECT_EQ(document().selectedProbe(), 0u);
  EXPECT_TRUE(tree()->selectionModel()->isSelected(probeRow(0)));
  EXPECT_FALSE(tree()->selectionModel()->isSelected(probeRow(1)));
  document().undo();
  EXPECT_FALSE(document().canUndo()) << "selecting edits nothing";
}

TEST_F(OutlinerTest, AnEyeChangesThePictureAndNeitherFileNorCaptures) {
  const Scene scene = document().scene();
  const QImage before = picture();
  const auto keys = renderer().bakeKeys("room");
  const std::uint64_t faces = counters().facesCaptured;
  const ImageRgbaF rendered = renderer().renderLinear(80, 50, 1);
  click(objectRow("sphere 9"), OutlinerModel::kEye);
  EXPECT_FALSE(window_->viewState().shown(Part::Object, "sphere 9"));
  const QImage hidden = picture();
  const QPoint high = pixelOf({0.55, 0.85, -0.3}).toPoint();  // no handle and no line lies there
  EXPECT_NE(hidden.pixel(high), before.pixel(high));
  const double share = differingShare(before, hidden);
  EXPECT_GT(share, 0.001);
  EXPECT_LT(share, 0.1) << "nothing else";
  keep("outliner-hidden");
  EXPECT_TRUE(document().scene() == scene);
  EXPECT_FALSE(document().canUndo());
  EXPECT_EQ(renderer().bakeKeys("room"), keys);
  EXPECT_EQ(counters().facesCaptured, faces);
  EXPECT_TRUE(renderer().renderLinear(80, 50, 1).pixels == rendered.pixels) << "pictures that are rendered have it";
  EXPECT_TRUE(document().selectedProbe()) << "the eye selects nothing";
  click(objectRow("sphere 9"), OutlinerModel::kEye);
  EXPECT_TRUE(picture() == before);
}

TEST_F(OutlinerTest, AnExportedPictureHasWhatIsHidden) {
  const QTemporaryDir folder;
  const auto exported = [&](const char* name) {
    const QString path = folder.filePath(name);
    const auto seen = answerFileDialog(path);
    key(Qt::Key_E, Qt::ControlModifier);
    waitUntilIdle();
    return QImage(path);
  };
  const QImage before = exported("before.png");
  ASSERT_FALSE(before.isNull());
  window_->viewState().setHidden(Part::Object, {"mirror", "sphere 9"}, true);
  window_->viewState().selectObjects({"pillars"});
  window_->viewState().setCutaway(true);
  const QImage hidden = picture();
  EXPECT_TRUE(exported("hidden.png") == before);
  EXPECT_TRUE(picture() == hidden) << "and the window still hides it";
}

TEST_F(OutlinerTest, HiddenAndIsolatedComeBackByteForByte) {
  const QImage before = picture();
  click(objectRow("pillars"));
  EXPECT_EQ(window_->viewState().objects(), (ViewState::Names{"pillars"}));
  window_->viewport().setFocus();
  key(Qt::Key_H);
  EXPECT_GT(differingShare(before, picture()), 0.005);
  key(Qt::Key_H, Qt::AltModifier);
  key(Qt::Key_Slash);
  EXPECT_TRUE(window_->viewState().isolated());
  EXPECT_FALSE(window_->viewState().shown(Part::Object, "mirror"));
  EXPECT_GT(differingShare(before, picture()), 0.3) << "the floor is gone";
  keep("outliner-isolated");
  key(Qt::Key_H, Qt::AltModifier);
  window_->viewState().selectObjects({});
  EXPECT_TRUE(picture() == before);
  EXPECT_FALSE(document().canUndo());
  // Of a probe: what reaches into its box.
  key(Qt::Key_Slash);
  EXPECT_TRUE(window_->viewState().shown(Part::Object, "sphere 9"));
  EXPECT_FALSE(window_->viewState().shown(Part::Object, "far hills"));
  key(Qt::Key_Slash);
  EXPECT_TRUE(picture() == before);
}

TEST_F(OutlinerTest, AHiddenProbeHasNoHandlesAndItsLightStays) {
  addProbe("second", {0.9, 0.3, 0.4});
  click(probeRow(0));
  window_->viewport().setFocus();
  const QImage before = picture();
  const QPointF top = pixelOf(faceCenterWorld(probe(0), {1, true}));
  ASSERT_EQ(window_->probeWidget().probeAt(top), 0u);
  key(Qt::Key_H);
  EXPECT_FALSE(window_->probeWidget().probeAt(top));
  EXPECT_FALSE(window_->probeWidget().probeAt(originPixel(0)));
  EXPECT_EQ(window_->probeWidget().probeAt(originPixel(1)), 1u) << "the other one's place among all";
  EXPECT_GT(differingShare(before, picture()), 0.0005);
  key(Qt::Key_H, Qt::AltModifier);
  EXPECT_TRUE(picture() == before);
  document().undo();
}

TEST_F(OutlinerTest, WhatIsLockedIsNotPickedAndNotDragged) {
  const BoxFace plusX{0, true};
  const QPointF from = facePixel(plusX);
  click(probeRow(0), OutlinerModel::kLock);
  drag(from, facePixelAfter(plusX, -0.5));
  EXPECT_FALSE(document().canUndo());
  key(Qt::Key_Home);
  click(probeRow(0), OutlinerModel::kLock);
  EXPECT_EQ(window_->probeWidget().probeAt(facePixel(plusX)), 0u);

  const glm::dvec3 sphere(-0.3, 0.5, 3.6);  // in front of nothing but the floor
  look({-0.3, 1.6, 1.0}, sphere);
  const QPointF at = pixelOf(sphere);
  ASSERT_EQ(firstAt(sphere), "sphere 6");
  click(objectRow("sphere 6"), OutlinerModel::kLock);
  move(at);
  press(at);
  release(at);
  EXPECT_EQ(window_->viewState().objects().count("sphere 6"), 0u);
  click(objectRow("sphere 6"), OutlinerModel::kLock);
  move(at);
  press(at);
  release(at);
  EXPECT_EQ(window_->viewState().objects(), (ViewState::Names{"sphere 6"}));
  EXPECT_TRUE(tree()->selectionModel()->isSelected(objectRow("sphere 6")));
}

TEST_F(OutlinerTest, ASelectedObjectHasAnOutlineAndNoneLeavesNone) {
  const QImage before = picture();
  const QPointF center = pixelOf({0.4, 0.5, -0.3});
  ASSERT_EQ(firstAt({0.4, 0.5, -0.3}), "sphere 9");
  move(center);
  press(center);
  release(center);
  ASSERT_EQ(window_->viewState().objects(), (ViewState::Names{"sphere 9"}));
  const QImage outlined = picture();
  keep("outline");
  // Around the sphere, half a metre of radius, and neither in its middle nor far off.
  const double radius = std::abs(pixelOf({0.4, 1.0, -0.3}).y() - center.y());
  int near = 0, elsewhere = 0;
  for (int y = 0; y < before.height(); ++y) {
    for (int x = 0; x < before.width(); ++x) {
      const QColor a(before.pixel(x, y)), b(outlined.pixel(x, y));
      if (std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 30) continue;
      const double away = std::hypot(x - center.x(), y - center.y()) / radius;
      (away > 0.75 && away < 1.6 ? near : elsewhere) += 1;
    }
  }
  EXPECT_GT(near, 60);
  EXPECT_LT(elsewhere, near / 20);
  window_->viewState().selectObjects({});
  EXPECT_TRUE(picture() == before);
}

TEST_F(OutlinerTest, NamesAreTypedInPlace) {
  click(probeRow(0));
  tree()->setFocus();
  QTest::keyClick(tree(), Qt::Key_F2);
  auto* field = tree()->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(field, nullptr);
  field->selectAll();
  QTest::keyClicks(field, "hall");
  QTest::keyClick(field, Qt::Key_Return);
  QCoreApplication::processEvents();
  QCoreApplication::processEvents();
  EXPECT_EQ(probe(0).name, "hall");
  EXPECT_EQ(probeRow(0).data().toString(), "hall");
  document().undo();
  const QModelIndex camera = outliner().model().index(1, 0, outliner().model().group(Kind::Cameras));
  tree()->setCurrentIndex(camera);
  QTest::keyClick(tree(), Qt::Key_F2);
  field = tree()->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(field, nullptr);
  field->selectAll();
  QTest::keyClicks(field, "desk");
  QTest::keyClick(field, Qt::Key_Return);
  QCoreApplication::processEvents();
  QCoreApplication::processEvents();
  EXPECT_EQ(document().scene().cameras.at(1).name, "desk");
  document().undo();
  EXPECT_FALSE(document().canUndo());
}

TEST_F(OutlinerTest, DeleteAndDuplicateLeaveProbesThatAreNotSelected) {
  const Scene before = document().scene();
  ASSERT_TRUE(document().selectedProbe());
  const OutlinerModel& model = outliner().model();
  const auto status = [this] { return window_->statusBar()->currentMessage().toStdString(); };
  for (const auto& [row, word] : {std::pair(objectRow("pillars"), "pillars is part of the model"),
                                  std::pair(model.index(0, 0, model.group(Kind::Lights)), "light"),
                                  std::pair(model.group(Kind::Objects), "Select a probe")}) {
    click(row);
    window_->viewport().setFocus();
    key(Qt::Key_Delete);
    EXPECT_NE(status().find(word), std::string::npos) << status();
    key(Qt::Key_D, Qt::ControlModifier);
    EXPECT_NE(status().find("Only probes"), std::string::npos) << status();
    EXPECT_TRUE(document().scene() == before);
  }
  window_->viewState().selectObjects({"pillars"});
  const auto menu = window_->tools().pictureMenu().menuAt(pixelOf({0.4, 0.85, -0.3}));
  for (const QAction* action : menu->actions()) {
    EXPECT_FALSE(action->shortcut() == QKeySequence(QKeySequence::Delete)) << "it would not delete the probe";
  }
  // The probe that is selected all the while, asked for in the picture.
  auto* remove = outliner().findChild<QToolButton*>("Delete");
  click(model.index(0, 0, model.group(Kind::Lights)));
  EXPECT_FALSE(remove->isEnabled());
  window_->editor().selectProbe(document().selectedProbe());
  EXPECT_TRUE(remove->isEnabled());
  EXPECT_TRUE(tree()->selectionModel()->isSelected(probeRow(0)));
  window_->viewport().setFocus();
  key(Qt::Key_D, Qt::ControlModifier);
  EXPECT_EQ(document().scene().probes.size(), before.probes.size() + 1);
  key(Qt::Key_Delete);
  EXPECT_TRUE(document().scene() == before);
  document().undo();
  document().undo();
}

TEST_F(OutlinerTest, ALightStaysSelectedWhileItIsEdited) {
  const QModelIndex light = outliner().model().index(0, 0, outliner().model().group(Kind::Lights));
  click(light);
  ASSERT_TRUE(tree()->selectionModel()->isSelected(light));
  const auto fields = window_->findChild<LightPanel*>()->findChildren<ValueField*>();
  const auto intensity =
      std::find_if(fields.begin(), fields.end(), [](auto* each) { return each->accessibleName() == "Intensity"; });
  ASSERT_NE(intensity, fields.end());
  const std::size_t examined = outliner().model().namesExamined();
  const float before = document().scene().lights[0].intensity;
  (*intensity)->setFocus();
  for (int i = 0; i < 3; ++i) key(Qt::Key_Up);
  EXPECT_GT(document().scene().lights[0].intensity, before);
  EXPECT_TRUE(tree()->selectionModel()->isSelected(light));
  EXPECT_EQ(outliner().model().namesExamined(), examined) << "no name has changed";
  window_->editor().finish();
  EXPECT_TRUE(tree()->selectionModel()->isSelected(light));
  window_->editor().commitProbe("Rename", [](Probe& probe) { probe.name = "hall"; });
  EXPECT_EQ(probeRow(0).data().toString(), "hall");
  document().undo();
  document().undo();
  window_->viewState().selectObjects({*outliner().model().nodes().begin()});
  EXPECT_FALSE(tree()->selectionModel()->isSelected(light));
}

TEST_F(OutlinerTest, WhatIsHiddenOfOneModelIsNotOfTheNext) {
  LoadedScene bare = smallBuilding();
  bare.path.clear();
  LoadedScene other = bare;
  other.scene.models.at(0).file = "another.glb";
  window_->showScene(bare);
  window_->viewState().setHidden(Part::Object, {"pillars"}, true);
  window_->showScene(bare);
  EXPECT_TRUE(window_->viewState().hidden(Part::Object, "pillars")) << "it was read again";
  window_->showScene(other);
  EXPECT_FALSE(window_->viewState().hidden(Part::Object, "pillars"));
}

// Qt compares each range of a selection with each: of thousands of pasted probes that was most of the time.
TEST_F(OutlinerTest, SelectedRowsThatTouchAreOneRange) {
  window_->editor().commit("Many", [](Scene& scene) {
    for (int i = 0; i < 11; ++i) {
      Probe more = scene.probes.front();
      more.name = i == 6 ? "attic a" : i == 8 ? "attic b" : "p" + std::to_string(i);
      scene.probes.push_back(more);
    }
  });
  const std::vector<std::size_t> wanted{1, 2, 3, 5, 7, 9, 10, 11};
  window_->editor().selectProbes(wanted);
  std::vector<std::size_t> selected;
  for (std::size_t i = 0; i < document().scene().probes.size(); ++i) {
    if (tree()->selectionModel()->isSelected(probeRow(i))) selected.push_back(i);
  }
  EXPECT_EQ(selected, wanted);
  std::set<std::pair<QModelIndex, int>> starts;  // rows whose upper neighbour is not selected
  for (const std::size_t i : wanted) {
    const QModelIndex row = probeRow(i), above = row.siblingAtRow(row.row() - 1);
    if (!tree()->selectionModel()->isSelected(above)) starts.emplace(row.parent(), row.row());
  }
  ASSERT_NE(probeRow(7).parent(), probeRow(1).parent());
  ASSERT_GT(starts.size(), 1u);
  ASSERT_LT(starts.size(), wanted.size());
  EXPECT_EQ(static_cast<std::size_t>(tree()->selectionModel()->selection().size()), starts.size());
}

// 300 probes: the tree stays where it was scrolled to, and the keys go where they went, whatever is selected elsewhere.
TEST_F(OutlinerTest, ManyProbesAndNothingScrollsOrTakesTheFocus) {
  window_->editor().commit("Many", [](Scene& scene) {
    for (int i = 0; i < 299; ++i) {
      Probe more = scene.probes.front();
      more.name = "room " + std::to_string(i / 4) + " " + static_cast<char>('a' + i % 4);
      scene.probes.push_back(more);
    }
  });
  ASSERT_EQ(outliner().model().probesShown().size(), 300u);
  QScrollBar* bar = tree()->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 50);
  bar->setValue(bar->maximum());
  window_->viewport().setFocus();
  window_->editor().selectProbe(0);
  window_->editor().selectProbe(3);
  QCoreApplication::processEvents();
  EXPECT_EQ(bar->value(), bar->maximum());
  EXPECT_TRUE(window_->viewport().hasFocus());
  EXPECT_TRUE(tree()->selectionModel()->isSelected(probeRow(3)));
  auto* filter = window_->findChild<QLineEdit*>("outlinerFilter");
  filter->setFocus();
  QTest::keyClicks(filter, "room 73");
  EXPECT_EQ(outliner().model().probesShown().size(), 4u);
  EXPECT_TRUE(filter->hasFocus());
  filter->clear();
  document().undo();
}

class CutawayTest : public OutlinerTest {
 protected:
  LoadedScene scene() const override {
    return smallBuilding({R"(probes.room.box={"min":[-4.505,-0.005,-4.505],"max":[4.505,5.005,4.505]})"});
  }
};

// What stands outside of the box is what hides it: hidden one by one, the picture must show the same in the box.
TEST_F(CutawayTest, LooksThroughWhatStandsBeforeTheBox) {
  look({13.0, 7.5, 10.0}, {0.0, 0.6, 0.0});
  const QImage before = picture();
  const std::uint64_t faces = counters().facesCaptured;
  const ImageRgbaF rendered = renderer().renderLinear(80, 50, 1);
  const glm::dvec3 spheres[] = {{-3.6, 0.5, -3.6}, {0.2, 0.5, -3.7},  {3.6, 0.5, -3.4},
                                {3.7, 0.5, 0.3},   {3.5, 0.5, 3.6},   {-0.3, 0.5, 3.6},
                                {-3.6, 0.5, 3.5},  {-3.7, 0.5, -0.2}, {0.4, 0.5, -0.3}};
  window_->viewport().setFocus();
  key(Qt::Key_B, Qt::AltModifier);
  const QImage cut = picture();
  keep("cutaway");
  EXPECT_TRUE(renderer().renderLinear(80, 50, 1).pixels == rendered.pixels) << "pictures that are rendered are whole";
  EXPECT_EQ(counters().facesCaptured, faces);
  const ViewState::Names shell{"pillars", "plinths and copings", "screens", "parapets", "beams", "rafters"};
  key(Qt::Key_B, Qt::AltModifier);
  EXPECT_TRUE(picture() == before);
  window_->viewState().setHidden(Part::Object, shell, true);
  const QImage open = picture();
  window_->viewState().showAll();
  int covered = 0;
  for (const glm::dvec3& sphere : spheres) {
    const QPoint at = pixelOf(sphere).toPoint();
    const QColor a(cut.pixel(at)), b(open.pixel(at)), c(before.pixel(at));
    const auto apart = [](const QColor& p, const QColor& q) {
      return std::max({std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
    };
    EXPECT_LE(apart(a, b), 3) << sphere.x << " " << sphere.z;
    covered += firstAt(sphere).rfind("sphere", 0) != 0 && apart(b, c) > 3 ? 1 : 0;
  }
  EXPECT_GE(covered, 2) << "else the view proves nothing";
}

TEST_F(CutawayTest, DraggingTheBoxMovesTheCutByUniformsAlone) {
  look({13.0, 7.5, 10.0}, {0.0, 0.6, 0.0});
  window_->viewport().setFocus();
  key(Qt::Key_B, Qt::AltModifier);
  const QImage before = picture();
  const BoxFace plusX{0, true};
  const QPointF from = facePixel(plusX), to = facePixelAfter(plusX, -1.5);
  press(from);
  // There and back once: where the box leaves an object, that one has a variant of its own.
  for (const double share : {0.2, 0.6, 1.0, 0.2}) {
    move(from + (to - from) * share);
    QTest::qWait(100);
  }
  const std::uint64_t programs = counters().programsCompiled, faces = counters().facesCaptured;
  for (int i = 3; i <= 10; ++i) {
    move(from + (to - from) * (0.1 * i - 0.03));
    QTest::qWait(20);
  }
  EXPECT_EQ(counters().programsCompiled, programs);
  EXPECT_EQ(counters().facesCaptured, faces);
  release(to);
  EXPECT_GT(differingShare(before, picture()), 0.002);
  document().undo();
  waitUntilIdle();
  key(Qt::Key_B, Qt::AltModifier);
}

// Eight by six metres, three high, closed all around.
class RoomTest : public OutlinerTest {
 protected:
  LoadedScene scene() const override {
    return loadScene(std::string(BOXPROBE_DATA_DIR) + "/scenes/room.boxprobe.json",
                     {"probes.room.faceSize=32", "probes.room.samplesPerPixel=1", "probes.room.bounces=1"});
  }
  static bool inside(const glm::dvec3& at) {
    return std::abs(at.x) < 4.0 && at.y > 0.0 && at.y < 3.0 && std::abs(at.z) < 3.0;
  }
};

TEST_F(RoomTest, FramingStaysIndoorsAndOutdoorsSaysWhatToDo) {
  window_->viewport().setFocus();
  for (const glm::dvec3& from : {glm::dvec3(-3.5, 2.1, 2.7), glm::dvec3(3.2, 0.7, -1.9), glm::dvec3(0.4, 2.7, 1.6)}) {
    look(from, {0.8, 0.9, -0.4});
    key(Qt::Key_F);
    const Camera camera = renderer().currentCamera();
    EXPECT_NEAR(glm::length(camera.target - probe().box.center()), 0.0, 1e-9);
    EXPECT_TRUE(inside(camera.position)) << camera.position.x << " " << camera.position.y << " " << camera.position.z;
    EXPECT_GT(glm::length(camera.position - camera.target), 1.0) << "not in the middle of it, either";
  }
  keep("framed-indoors");
  click(objectRow("sphere 1"));
  window_->viewport().setFocus();
  key(Qt::Key_F);
  const Camera near = renderer().currentCamera();
  EXPECT_TRUE(inside(near.position));
  EXPECT_NEAR(glm::length(near.target - renderer().objectBounds("sphere 1")->center()), 0.0, 1e-9);
  window_->viewState().selectObjects({});
  look({0.5, 4.0, 14.0}, {0.0, 1.0, 0.0});
  window_->statusBar()->clearMessage();
  key(Qt::Key_F);
  EXPECT_FALSE(inside(renderer().currentCamera().position)) << "who is outside stays outside";
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains("Alt+B"));
}

// The wall at z = 3, seen from inside, is cut where a box beyond it begins close enough, and stays where the box begins
// farther before it; from far and from near.
TEST_F(RoomTest, PicksAgreeWithThePictureAtTheEdgeOfTheCut) {
  const auto at = [this](const glm::dvec3& point) {
    const QPointF pixel = pixelOf(point);
    SceneSurfaces surfaces(document());
    surfaces.setModels(window_->models());
    surfaces.setView({{}, {}, renderer().windowView().cutaway});
    const auto picked = surfaces.objectAt(window_->viewport().view().ray({pixel.x(), pixel.y()}));
    const QSize size = window_->viewport().size();
    const Explanation told = renderer().explain(pixel.toPoint().x(), pixel.toPoint().y(), size.width(), size.height());
    EXPECT_EQ(picked ? picked->node : "", told.surface.object);
    return told.surface.object;
  };
  const auto drawn = [this](const glm::dvec3& point) { return QColor(picture().pixel(pixelOf(point).toPoint())); };
  // From outside the wall north is seen through: its faces look inwards.
  for (const double from : {2.3, -40.0}) {
    look({0.9, 1.3, from}, {0.9, 1.3, 8.0});
    const glm::dvec3 point(0.9 + 0.02 * (3.0 - from), 1.3 + 0.03 * (3.0 - from), 3.0);
    const QColor whole = drawn(point);
    ASSERT_EQ(at(point), "wall south");
    window_->viewState().setCutaway(true);
    for (const double before : {0.03, 0.12}) {
      window_->editor().commitProbe("Box", [before](Probe& probe) {
        probe.box = {{-4.0, 0.0, 3.0 - before}, {4.0, 3.0, 9.0}};
      });
      EXPECT_EQ(at(point) == "wall south", before > 0.1) << from << " " << before;
      EXPECT_EQ(drawn(point) == whole, before > 0.1) << from << " " << before;
      document().undo();
    }
    window_->viewState().setCutaway(false);
  }
}

TEST_F(RoomTest, RaysPassWhatIsHidden) {
  SceneSurfaces surfaces(document());
  surfaces.setModels(window_->models());
  const glm::dvec3 center = renderer().objectBounds("sphere 1")->center();
  const Ray down{{center.x, 2.9, center.z}, {0.0, -1.0, 0.0}};
  const auto sphere = surfaces.meet(down);
  ASSERT_TRUE(sphere.has_value());
  EXPECT_GT(sphere->y, center.y);
  surfaces.setView({{"sphere 1"}, {}, {}});
  const auto below = surfaces.meet(down);
  ASSERT_TRUE(below.has_value());
  EXPECT_LT(below->y, center.y);
  surfaces.setView({});
  EXPECT_EQ(*surfaces.meet(down), *sphere);
}

// A wall that is drawn from inside alone is seen through from outside, and so it is for a click.
TEST_F(RoomTest, AClickGoesThroughWhatIsSeenThroughAndThroughTheCut) {
  const auto clicked = [this](const glm::dvec3& point) {
    window_->viewState().selectObjects({});
    const QPointF at = pixelOf(point);
    move(at);
    press(at);
    release(at);
    return window_->viewState().objects();
  };
  look({0.5, 4.0, 14.0}, {0.0, 1.0, 0.0});
  window_->viewport().setFocus();
  EXPECT_EQ(clicked({-2.4, 0.0, 1.1}), (ViewState::Names{"floor"}));
  // The box begins behind a sphere and before the wall that is behind it.
  const glm::dvec3 center = renderer().objectBounds("sphere 1")->center();
  window_->editor().commitProbe("Box", [&](Probe& probe) {
    probe.box = {{-4.0, 0.0, center.z + 0.7}, {4.0, 3.0, 3.01}};
  });
  look(center - glm::dvec3(0.0, 0.0, 1.4), center);
  const glm::dvec3 aside = center + glm::dvec3(0.13, 0.11, 0.0);
  EXPECT_EQ(clicked(aside), (ViewState::Names{"sphere 1"}));
  key(Qt::Key_B, Qt::AltModifier);
  keep("cutaway-room");
  EXPECT_EQ(clicked(aside), (ViewState::Names{"wall south"}));
  key(Qt::Key_B, Qt::AltModifier);
  document().undo();
}

}  // namespace
}  // namespace boxprobe
