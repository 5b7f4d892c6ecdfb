// Several probes at once: selected in the list and in the picture, moved, turned, nudged, set, copied, baked and
// deleted together, each as one undo step.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QTreeView>
#include <glm/geometric.hpp>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/panels/outliner.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/differs.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/window/probe_clipboard.h"
#include "app/gui/window/view_tools.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/technique/technique_table.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/handle_drag.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

using Places = std::vector<std::size_t>;

class SeveralProbesTest : public WindowTest {
 protected:
  // Three probes whose origins the first camera sees apart from each other.
  void SetUp() override {
    WindowTest::SetUp();
    window_->probeWidget().setMode(HandleMode::Place);
    window_->editor().commit("Three", [](Scene& scene) {
      for (const char* name : {"second", "third"}) {
        Probe copy = movedProbe(scene.probes.front(), {0.6 * static_cast<double>(scene.probes.size()), 0.0, 0.4});
        copy.name = name;
        copy.origin.y += 0.35 * static_cast<double>(scene.probes.size());
        scene.probes.push_back(copy);
      }
    });
    waitUntilIdle();
    steps_ = document().stepLabels().size();
  }
  void TearDown() override { window_->probeWidget().setMode(HandleMode::Box); }

  QTreeView* list() const { return window_->findChild<Outliner*>()->tree(); }
  QModelIndex rowOf(std::size_t probe) const { return window_->findChild<Outliner*>()->model().probe(probe); }
  void clickRow(std::size_t row, Qt::KeyboardModifiers modifiers = {}) {
    list()->scrollTo(rowOf(row));
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, modifiers, list()->visualRect(rowOf(row)).center());
  }
  Places chosen() const { return window_->editor().selected(); }
  Places rows() const {
    Places rows;
    for (std::size_t row = 0; row < window_->document().scene().probes.size(); ++row) {
      if (rowOf(row).isValid() && list()->selectionModel()->isSelected(rowOf(row))) rows.push_back(row);
    }
    return rows;
  }
  void selectAll() {
    window_->viewport().setFocus();
    key(Qt::Key_A, Qt::ControlModifier);
    ASSERT_EQ(chosen(), (Places{0, 1, 2}));
  }
  template <typename Field>
  Field* field(const char* name) {
    auto* found = window_->findChild<Field*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  std::vector<Probe> probes() const { return window_->document().scene().probes; }
  std::size_t newSteps() { return document().stepLabels().size() - steps_; }

  std::size_t steps_ = 0;
};

TEST_F(SeveralProbesTest, TheListSelectsSeveralWithCtrlAndShift) {
  clickRow(0);
  EXPECT_EQ(chosen(), Places{0});
  clickRow(2, Qt::ControlModifier);
  EXPECT_EQ(chosen(), (Places{0, 2}));
  EXPECT_EQ(document().selectedProbe(), 2u) << "the last one's handles are shown";
  EXPECT_EQ(rows(), (Places{0, 2}));
  clickRow(2, Qt::ControlModifier);
  EXPECT_EQ(chosen(), Places{0});
  clickRow(0);
  clickRow(2, Qt::ShiftModifier);
  EXPECT_EQ(chosen(), (Places{0, 1, 2}));
  clickRow(1);
  EXPECT_EQ(chosen(), Places{1});
  EXPECT_EQ(rows(), Places{1});
  EXPECT_EQ(newSteps(), 0u) << "selecting edits nothing";
}

TEST_F(SeveralProbesTest, ThePictureSelectsSeveralWithCtrl) {
  clickRow(0);
  const auto click = [this](std::size_t probe, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF at = originPixel(probe);
    move(at, modifiers);
    press(at, modifiers);
    release(at, modifiers);
  };
  click(1, Qt::ControlModifier);
  EXPECT_EQ(chosen(), (Places{0, 1}));
  EXPECT_EQ(rows(), (Places{0, 1})) << "the list shows it";
  click(2, Qt::ControlModifier);
  EXPECT_EQ(chosen(), (Places{0, 1, 2}));
  waitUntilIdle();
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) window_->grab().save(QString(folder) + "/several.png");
  click(2, Qt::ControlModifier);
  EXPECT_EQ(chosen(), (Places{0, 1})) << "again: taken out";
  click(2);
  EXPECT_EQ(chosen(), Places{2}) << "without Ctrl: that one alone";
  EXPECT_EQ(newSteps(), 0u);
}

TEST_F(SeveralProbesTest, AnArrowMovesAllAsOneStep) {
  selectAll();
  const std::vector<Probe> before = probes();
  const Probe& shown = *window_->editor().probe();
  const std::size_t at = *document().selectedProbe();
  const Handle along{HandleKind::Move, at, {0, true}};
  const auto grip = handleGripWorld(shown, along, window_->viewport().view());
  const QPointF from = pixelOf(grip.back()), to = pixelOf(grip.back() + 0.5 * handleAxisWorld(shown, along));
  drag(from, to);
  const glm::dvec3 by = probe(at).origin - before[at].origin;
  EXPECT_NEAR(by.x, 0.5, 0.05);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Probe wanted = movedProbe(before[i], by);
    EXPECT_LT(glm::length(probe(i).origin - wanted.origin), 1e-9) << i;
    EXPECT_LT(glm::length(probe(i).box.min - wanted.box.min), 1e-9) << i;
  }
  EXPECT_EQ(newSteps(), 1u);
  EXPECT_EQ(document().undoLabel(), "Move 3 probes");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(probes() == before);
  EXPECT_EQ(chosen(), (Places{0, 1, 2})) << "undo keeps the selection";
}

TEST_F(SeveralProbesTest, ARingTurnsAllAboutTheOneThatIsShownAndEscapeRestoresThem) {
  selectAll();
  const std::size_t at = *document().selectedProbe();
  const std::vector<Probe> before = probes();
  const glm::dvec3 middle = before[at].box.center();
  window_->tools().views().lookAtSpot(middle, middle + glm::dvec3(4.0, 8.0, 6.0));
  waitUntilIdle();
  const auto ring = handleGripWorld(before[at], {HandleKind::Turn, at, {1, true}}, window_->viewport().view());
  // Taken where no arrow and no diamond is nearer, and led along it for an eighth.
  const auto takes = [&](std::size_t i) {
    const QPointF pixel = pixelOf(ring[i]);
    const auto under =
        handleAt(before, at, window_->viewport().view(), {pixel.x(), pixel.y()}, 12.0, HandleMode::Place);
    return under && under->kind == HandleKind::Turn && under->face.axis == 1;
  };
  std::size_t first = 0;
  while (first < 40 && !takes(first)) ++first;
  ASSERT_LT(first, 40u);
  press(pixelOf(ring[first]));
  for (std::size_t i = first + 1; i <= first + 6; ++i) move(pixelOf(ring[i]));
  const double turned = probe(at).rotationDegrees.y;
  EXPECT_NEAR(std::abs(turned), 45.0, 1.0);
  const glm::dmat3 turn = rotationMatrix({0.0, turned, 0.0});
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(probe(i).rotationDegrees.y, turned, 1e-9) << i;
    const glm::dvec3 center = middle + turn * (before[i].box.center() - middle);
    EXPECT_LT(glm::length(probe(i).box.center() - center), 1e-9) << i;
    EXPECT_LT(glm::length(probe(i).origin - (middle + turn * (before[i].origin - middle))), 1e-9) << i;
  }
  key(Qt::Key_Escape);
  release(pixelOf(ring[first + 6]));
  EXPECT_TRUE(probes() == before);
  EXPECT_EQ(newSteps(), 0u);
}

TEST_F(SeveralProbesTest, ArrowKeysNudgeAllInOneStep) {
  selectAll();
  move({3, 3});
  const std::vector<Probe> before = probes();
  keyDown(Qt::Key_PageUp);
  keyDown(Qt::Key_PageUp);
  keyUp(Qt::Key_PageUp);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(probe(i).origin.y, before[i].origin.y + 0.2, 1e-9) << i;
    EXPECT_NEAR(probe(i).box.max.y, before[i].box.max.y + 0.2, 1e-9) << i;
  }
  EXPECT_EQ(newSteps(), 1u);
  document().undo();
  EXPECT_TRUE(probes() == before);
}

TEST_F(SeveralProbesTest, ThePanelShowsWhatTheyShareAndADashWhereTheyDiffer) {
  window_->editor().commit("Differ", [](Scene& scene) {
    scene.probes[1].intensity = 2.0;
    scene.probes[1].technique = "infinite";
    scene.probes[2].projection = false;
  });
  clickRow(1);
  auto* intensity = field<ValueField>("intensity");
  EXPECT_FALSE(intensity->differs());
  EXPECT_EQ(intensity->value(), 2.0);
  selectAll();
  EXPECT_TRUE(intensity->differs());
  EXPECT_EQ(intensity->text().trimmed(), differsText());
  EXPECT_FALSE(field<ValueField>("importance")->differs());
  EXPECT_EQ(field<QCheckBox>("projection")->checkState(), Qt::PartiallyChecked);
  auto* technique = static_cast<QuietCombo*>(field<QComboBox>("techniqueProjection"));
  EXPECT_TRUE(technique->differs());
  EXPECT_FALSE(static_cast<QuietCombo*>(field<QComboBox>("techniqueEvaluation"))->differs());
  waitUntilIdle();
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) window_->grab().save(QString(folder) + "/differ.png");
  clickRow(0);
  EXPECT_FALSE(intensity->differs());
  EXPECT_EQ(field<QCheckBox>("projection")->checkState(), Qt::Checked);
  EXPECT_FALSE(technique->differs());
}

// Six distances, one of which differs: the dash stands at that face and at no other.
TEST_F(SeveralProbesTest, ABlendDistanceThatDiffersIsMarkedAtItsFace) {
  for (int face = 0; face < 6; ++face) {
    SCOPED_TRACE(face);
    window_->editor().commit("Differ", [face](Scene& scene) {
      for (Probe& probe : scene.probes) probe.blendDistance = {{0.11, 0.22, 0.33}, {0.44, 0.55, 0.66}};
      BlendDistance& blend = scene.probes[2].blendDistance;
      (face % 2 == 1 ? blend.max : blend.min)[face / 2] = 0.77;
    });
    selectAll();
    EXPECT_TRUE(field<QWidget>("blendDistance")->findChild<ValueField*>()->differs()) << "of all";
    for (int other = 0; other < 6; ++other) {
      const QWidget* row = field<QWidget>(other % 2 == 1 ? "blendPlusFaces" : "blendMinusFaces");
      const QList<ValueField*> xyz = row->findChildren<ValueField*>();
      ASSERT_EQ(xyz.size(), 3);
      EXPECT_EQ(xyz[other / 2]->differs(), other == face) << other;
    }
  }
}

TEST_F(SeveralProbesTest, WhatIsSetInThePanelIsSetForAllAsOneStep) {
  window_->editor().commit("Differ", [](Scene& scene) {
    scene.probes[1].intensity = 2.0;
    scene.probes[2].blendDistance.min.x = 0.25;
  });
  steps_ = document().stepLabels().size();
  selectAll();
  // The number that stands behind the dash counts, too.
  auto* intensity = field<ValueField>("intensity");
  const double behind = intensity->value();
  type(intensity, QString::number(behind));
  EXPECT_EQ(newSteps(), 1u);
  EXPECT_EQ(document().undoLabel(), "Set intensity of 3 probes");
  for (const Probe& each : probes()) EXPECT_EQ(each.intensity, behind);
  EXPECT_FALSE(intensity->differs());

  const std::vector<Probe> before = probes();
  type(field<QWidget>("blendDistance")->findChild<ValueField*>(), "0.75");
  EXPECT_EQ(newSteps(), 2u);
  for (const Probe& each : probes()) {
    EXPECT_EQ(each.blendDistance.min, glm::dvec3(0.75));
    EXPECT_EQ(each.blendDistance.max, glm::dvec3(0.75));
  }
  document().undo();
  EXPECT_TRUE(probes() == before);

  auto* projection = field<QComboBox>("techniqueProjection");
  projection->setFocus();
  const int infinite = projection->findText("Infinite", Qt::MatchStartsWith);
  ASSERT_GE(infinite, 0);
  while (projection->currentIndex() != infinite) {
    key(projection->currentIndex() < infinite ? Qt::Key_Down : Qt::Key_Up);
  }
  for (const Probe& each : probes()) EXPECT_EQ(each.technique.rfind("infinite", 0), 0u) << each.technique;
  EXPECT_TRUE(document().undoLabel() == "Set technique of 3 probes") << document().undoLabel();
}

TEST_F(SeveralProbesTest, OneHalfOfATechniqueLeavesEachProbesOtherHalf) {
  window_->editor().commit("Differ", [](Scene& scene) {
    scene.probes[0].technique = "footprint4";
    scene.probes[1].technique = "infinite";
    scene.probes[2].technique = "hdrp";
  });
  steps_ = document().stepLabels().size();
  selectAll();
  const std::vector<Probe> before = probes();
  const auto choose = [this](const char* name, int row) {
    auto* combo = field<QComboBox>(name);
    combo->setCurrentIndex(combo->findData(row));
    emit combo->activated(combo->currentIndex());
  };
  const auto techniques = [this] {
    std::vector<std::string> ids;
    for (const Probe& each : probes()) ids.push_back(each.technique);
    return ids;
  };
  choose("techniqueProjection", parseTechnique("infinite")->projection);
  EXPECT_EQ(techniques(), (std::vector<std::string>{"infinite+footprint4", "infinite", "infinite+hdrp"}));
  EXPECT_EQ(newSteps(), 1u);
  document().undo();
  EXPECT_TRUE(probes() == before);
  choose("techniqueEvaluation", parseTechnique("hdrp")->evaluation);
  EXPECT_EQ(techniques(), (std::vector<std::string>{"hdrp", "infinite+hdrp", "hdrp"}));
  document().undo();
  // What stands for the box alone takes it.
  choose("techniqueEvaluation", parseTechnique("auto")->evaluation);
  EXPECT_EQ(techniques(), (std::vector<std::string>{"auto", "auto", "auto"}));
  choose("techniqueProjection", parseTechnique("infinite")->projection);
  EXPECT_EQ(techniques(), (std::vector<std::string>{"infinite", "infinite", "infinite"}));
}

TEST_F(SeveralProbesTest, WhatTheSearchHidesIsNotSelectedAndNotDeleted) {
  auto* filter = field<QLineEdit>("outlinerFilter");
  selectAll();
  filter->setText("d");  // second, third
  EXPECT_EQ(chosen(), (Places{1, 2}));
  EXPECT_EQ(rows(), (Places{1, 2}));
  filter->setText("sec");
  EXPECT_EQ(chosen(), Places{1});
  filter->setText("room");
  EXPECT_EQ(chosen(), Places{1}) << "the one on show may stay";
  filter->setText("d");
  window_->viewport().setFocus();
  key(Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(chosen(), (Places{1, 2}));
  key(Qt::Key_Delete);
  ASSERT_EQ(probes().size(), 1u);
  EXPECT_EQ(probe(0).name, "room");
  document().undo();
  filter->clear();
}

TEST_F(SeveralProbesTest, ARangeLeavesOutWhatTheSearchHides) {
  window_->editor().commit("Rename", [](Scene& scene) { scene.probes[1].name = "x"; });
  auto* filter = field<QLineEdit>("outlinerFilter");
  filter->setText("r");  // room, third
  clickRow(0);
  clickRow(2, Qt::ShiftModifier);
  EXPECT_EQ(chosen(), (Places{0, 2}));
  EXPECT_EQ(rows(), (Places{0, 2}));
  filter->clear();
}

TEST_F(SeveralProbesTest, RenamingTheOneOnShowKeepsTheOthersSelected) {
  selectAll();
  const std::size_t at = *document().selectedProbe();
  list()->setFocus();
  list()->edit(rowOf(at));
  auto* name = list()->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(name, nullptr);
  name->selectAll();
  QTest::keyClicks(name, "hall");
  QTest::keyClick(name, Qt::Key_Return);
  // The tree takes the text over in the next turn, and hands it on in the one after.
  for (int turn = 0; turn < 2; ++turn) QCoreApplication::processEvents();
  ASSERT_EQ(probe(at).name, "hall");
  EXPECT_EQ(chosen(), (Places{0, 1, 2}));
  window_->editor().undo();
  EXPECT_NE(probe(at).name, "hall");
  EXPECT_EQ(chosen(), (Places{0, 1, 2}));
  window_->editor().redo();
  EXPECT_EQ(chosen(), (Places{0, 1, 2}));
  EXPECT_EQ(rows(), (Places{0, 1, 2}));
}

TEST_F(SeveralProbesTest, AnEditThatMovesTheSelectionTellsIt) {
  clickRow(2);
  int told = 0;
  const auto connection = QObject::connect(&window_->editor(), &Editor::selectionChanged, [&told] { ++told; });
  window_->editor().commit("Erase", [](Scene& scene) { scene.probes.erase(scene.probes.begin()); });
  EXPECT_EQ(chosen(), Places{1});
  EXPECT_EQ(told, 1);
  window_->editor().commitProbe("Set intensity", [](Probe& edited) { edited.intensity = 2.0; });
  EXPECT_EQ(told, 1) << "the same is selected";
  QObject::disconnect(connection);
}

TEST_F(SeveralProbesTest, ColoursThatDifferAreMarkedChannelByChannel) {
  window_->editor().commit("Colours", [](Scene& scene) {
    scene.probes[0].clear = glm::vec3(1.0f, 0.0f, 0.25f);
    scene.probes[1].clear = glm::vec3(1.0f, 0.5f, 0.25f);
    scene.probes[2].clear = glm::vec3(1.0f, 0.5f, 0.25f);
  });
  selectAll();
  const auto channels = field<QWidget>("clearColor")->findChildren<ValueField*>();
  ASSERT_EQ(channels.size(), 3);
  EXPECT_FALSE(channels[0]->differs());
  EXPECT_TRUE(channels[1]->differs());
  EXPECT_FALSE(channels[2]->differs());
  clickRow(0);
  EXPECT_FALSE(channels[1]->differs());
}

TEST_F(SeveralProbesTest, OneFieldOfOneAxisLeavesTheOthers) {
  selectAll();
  const std::vector<Probe> before = probes();
  type(field<QWidget>("origin")->findChildren<ValueField*>().at(1), "1.25");
  EXPECT_EQ(newSteps(), 1u);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(probe(i).origin, glm::dvec3(before[i].origin.x, 1.25, before[i].origin.z)) << i;
  }
}

TEST_F(SeveralProbesTest, DuplicateCopyPasteAndDeleteTakeAllAsOneStepEach) {
  clickRow(0);
  clickRow(1, Qt::ControlModifier);
  const std::vector<Probe> before = probes();
  window_->viewport().setFocus();
  key(Qt::Key_D, Qt::ControlModifier);
  ASSERT_EQ(probes().size(), 5u);
  EXPECT_EQ(document().undoLabel(), "Duplicate 2 probes");
  EXPECT_EQ(chosen(), (Places{2, 3})) << "the copies are selected";
  EXPECT_EQ(probe(4), before[2]);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(probes() == before);

  clickRow(0);
  clickRow(2, Qt::ControlModifier);
  window_->viewport().setFocus();
  key(Qt::Key_C, Qt::ControlModifier);
  const auto copied = probesFromText(QApplication::clipboard()->text().toStdString());
  ASSERT_EQ(copied.size(), 2u);
  EXPECT_EQ(copied[0], before[0]);
  EXPECT_EQ(copied[1], before[2]);
  key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(probes().size(), 5u);
  EXPECT_EQ(chosen(), (Places{3, 4}));
  EXPECT_EQ(document().undoLabel(), "Paste 2 probes");
  key(Qt::Key_Delete);
  EXPECT_TRUE(probes() == before);
  EXPECT_EQ(document().undoLabel(), "Delete 2 probes");
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(probes().size(), 5u);
  EXPECT_EQ(chosen(), (Places{3, 4})) << "what comes back is selected";
  EXPECT_EQ(newSteps(), 2u);
}

TEST_F(SeveralProbesTest, BakeTakesTheSelectedOnesAndNoOther) {
  clickRow(1);
  clickRow(2, Qt::ControlModifier);
  waitUntilIdle();
  const Counters before = counters();
  window_->viewport().setFocus();
  key(Qt::Key_F5);
  waitUntilIdle();
  EXPECT_EQ(counters().facesCaptured - before.facesCaptured, 12u);
  EXPECT_EQ(newSteps(), 0u);
}

TEST_F(SeveralProbesTest, FrameSeesAllThatAreSelected) {
  selectAll();
  key(Qt::Key_F);
  const ViewProjection view = window_->viewport().view();
  for (const Probe& each : probes()) {
    for (const BoxFace& face : kBoxFaces) {
      const auto at = view.pixel(faceCenterWorld(each, face));
      ASSERT_TRUE(at) << each.name;
      EXPECT_TRUE(QRectF(window_->viewport().rect()).contains(QPointF(at->x, at->y))) << each.name;
    }
  }
}

}  // namespace
}  // namespace boxprobe
