// The panel: every field edits what it says, as one undo step, and shows what the document holds.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include "app/gui/panels/blend_row.h"
#include "app/gui/panels/technique_chooser.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/axis_colors.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "filters/math/technique/technique_table.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class ProbePanelTest : public WindowTest {
 protected:
  template <typename Widget>
  Widget* named(const char* name) const {
    auto* widget = window_->findChild<Widget*>(name);
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  VectorRow* row(const char* name) const { return named<VectorRow>(name); }
  /// Chooses as a user does: by the keyboard, with the list open.
  void choose(QComboBox* combo, int index) {
    combo->setFocus();
    combo->showPopup();
    QTest::qWait(20);
    combo->view()->setCurrentIndex(combo->model()->index(index, 0));
    QTest::keyClick(combo->view(), Qt::Key_Return);
    waitUntilIdle();
  }
  std::size_t steps() {
    std::size_t count = 0;
    while (document().canUndo()) {
      document().undo();
      ++count;
    }
    return count;
  }
};

TEST_F(ProbePanelTest, ShowsTheSelectedProbe) {
  EXPECT_DOUBLE_EQ(row("boxMax")->field(0)->value(), 1.5);
  EXPECT_DOUBLE_EQ(row("origin")->field(1)->value(), 1.6);
  EXPECT_EQ(row("boxMax")->field(0)->suffix(), " m");
  const Technique box = *parseTechnique("box");
  EXPECT_EQ(named<TechniqueChooser>("technique")->projection()->currentData().toInt(), box.projection);
  EXPECT_EQ(named<TechniqueChooser>("technique")->evaluation()->currentData().toInt(), box.evaluation);
}

TEST_F(ProbePanelTest, ATypedNumberIsOneStep) {
  type(row("boxMax")->field(0), "3.25");
  EXPECT_EQ(probe().box.max.x, 3.25);
  EXPECT_EQ(probe().box.min.x, -2.0);
  EXPECT_EQ(document().undoLabel(), "Set box max X of room");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(probe().box.max.x, 1.5);
  EXPECT_FALSE(document().canUndo());
  EXPECT_DOUBLE_EQ(row("boxMax")->field(0)->value(), 1.5) << "the field must follow the undo";
}

TEST_F(ProbePanelTest, EveryNumberReachesItsPlace) {
  type(row("origin")->field(2), "-1.5");
  EXPECT_EQ(probe().origin.z, -1.5);
  type(row("boxMin")->field(1), "0.25");
  EXPECT_EQ(probe().box.min.y, 0.25);
  type(row("rotation")->field(1), "30");
  EXPECT_EQ(probe().rotationDegrees.y, 30.0);
  type(named<ValueField>("importance"), "2.5");
  EXPECT_EQ(probe().importance, 2.5);
  type(named<ValueField>("intensity"), "0.5");
  EXPECT_EQ(probe().intensity, 0.5);
  type(named<BlendRow>("blendDistance")->minFaces()->field(1), "0");
  EXPECT_EQ(probe().blendDistance.min.y, 0.0);
  EXPECT_EQ(probe().blendDistance.max.y, 0.5);
  QTest::mouseClick(named<QCheckBox>("projection"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_FALSE(probe().projection);
  EXPECT_EQ(steps(), 7u);
}

TEST_F(ProbePanelTest, ANumberThatWouldTurnTheBoxInsideOutCannotBeEntered) {
  type(row("boxMin")->field(0), "99");
  EXPECT_LE(probe().box.min.x, probe().box.max.x - kMinimumThickness + 1e-9);
  type(named<BlendRow>("blendDistance")->all(), "-3");
  EXPECT_GE(probe().blendDistance.min.x, 0.0);
}

TEST_F(ProbePanelTest, BlendDistanceMovesTheInnerBox) {
  const auto innerEdge = [this](double blend) {
    const Box& box = probe().box;
    const glm::dvec3 a(box.min.x + blend, box.max.y - blend, box.min.z + blend);
    const glm::dvec3 b(box.max.x - blend, box.max.y - blend, box.min.z + blend);
    constexpr double kRadius = 2.0;
    constexpr int kTolerance = 60;
    return pixelsNear(shownPicture(window_->viewport()), pixelOf(a), pixelOf(b), kRadius, blendColor(), kTolerance);
  };
  const int halfBefore = innerEdge(0.5);
  const int oneBefore = innerEdge(1.0);
  type(named<BlendRow>("blendDistance")->all(), "1");
  waitUntilIdle();
  EXPECT_EQ(probe().blendDistance.min, glm::dvec3(1.0));
  EXPECT_EQ(probe().blendDistance.max, glm::dvec3(1.0));
  EXPECT_GT(halfBefore, 60);
  EXPECT_LT(oneBefore, 20);
  EXPECT_GT(innerEdge(1.0), 60);
  EXPECT_LT(innerEdge(0.5), 20);
}

TEST_F(ProbePanelTest, TheTechniquesAreThoseOfTheTable) {
  auto* chooser = named<TechniqueChooser>("technique");
  EXPECT_EQ(static_cast<std::size_t>(chooser->projection()->count()), projectionRows().size());
  EXPECT_EQ(static_cast<std::size_t>(chooser->evaluation()->count()), evaluationRows().size());
  for (const QComboBox* combo : {chooser->projection(), chooser->evaluation()}) {
    for (int i = 0; i < combo->count(); ++i) {
      EXPECT_FALSE(combo->itemText(i).isEmpty()) << i;
      EXPECT_FALSE(combo->itemData(i, Qt::ToolTipRole).toString().isEmpty()) << i;
    }
  }
}

TEST_F(ProbePanelTest, AnEvaluationThatDoesNotCombineGivesWay) {
  auto* chooser = named<TechniqueChooser>("technique");
  choose(chooser->evaluation(), chooser->evaluation()->findData(parseTechnique("auto")->evaluation));
  EXPECT_EQ(probe().technique, "auto");
  choose(chooser->projection(), chooser->projection()->findData(parseTechnique("sphere")->projection));
  EXPECT_EQ(probe().technique, "sphere");
}

TEST_F(ProbePanelTest, TheTechniqueChangesThePictureAtOnceAndItsHelp) {
  auto* chooser = named<TechniqueChooser>("technique");
  auto* help = named<QLabel>("techniqueHelp");
  // Over the whole building, floor and all.
  window_->editor().commitProbe("Set box", [](Probe& edited) {
    edited.box = {glm::dvec3(-4.505, -0.005, -4.505), glm::dvec3(4.505, 5.005, 4.505)};
    edited.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
  });
  waitUntilIdle();
  const QImage box = shownPicture(window_->viewport());
  const QString boxHelp = help->text();
  const std::uint64_t faces = counters().facesCaptured;
  choose(chooser->projection(), chooser->projection()->findData(parseTechnique("infinite")->projection));
  EXPECT_EQ(probe().technique, "infinite");
  EXPECT_GT(differingShare(box, shownPicture(window_->viewport())), 0.01);
  EXPECT_NE(help->text(), boxHelp);
  EXPECT_EQ(counters().facesCaptured, faces) << "a technique looks the capture up, it does not change it";
  key(Qt::Key_Z, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_EQ(probe().technique, "box");
  EXPECT_LT(differingShare(box, shownPicture(window_->viewport())), 1e-3);
}

TEST_F(ProbePanelTest, TheParametersAreThoseOfTheTechnique) {
  QComboBox* evaluation = named<TechniqueChooser>("technique")->evaluation();
  auto* length = named<ValueField>("hardeningLength");
  auto* power = named<ValueField>("power");
  auto* curve = named<QComboBox>("curve");
  EXPECT_FALSE(length->isVisible());
  EXPECT_TRUE(curve->isVisible());
  choose(evaluation, evaluation->findData(parseTechnique("approximate")->evaluation));
  EXPECT_TRUE(length->isVisible());
  EXPECT_FALSE(power->isVisible());
  choose(evaluation, evaluation->findData(parseTechnique("godot")->evaluation));
  EXPECT_TRUE(power->isVisible());
  EXPECT_DOUBLE_EQ(length->value(), 6.0) << "the default";
  const std::uint64_t faces = counters().facesCaptured;
  type(length, "2.5");
  type(power, "3");
  choose(curve, curve->findText("As Unity"));
  EXPECT_EQ(document().undoLabel(), "Set blur by roughness of room");
  const std::map<std::string, ParameterValue> expected = {
      {"hardeningLength", 2.5}, {"power", 3.0}, {"curve", std::string("unity")}};
  EXPECT_EQ(probe().parameters, expected);
  EXPECT_EQ(counters().facesCaptured, faces);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(curve->currentText(), "As this probe is filtered");
  EXPECT_DOUBLE_EQ(power->value(), 4.0);
  type(length, "6");
  EXPECT_TRUE(probe().parameters.empty()) << "a default is not written down";
}

TEST_F(ProbePanelTest, FaceSizeAndBouncesRecapture) {
  const std::uint64_t before = counters().facesCaptured;
  auto* size = named<QComboBox>("faceSize");
  // No other test has it: what a window has captured once for the same inputs, it keeps.
  choose(size, size->findData(128));
  EXPECT_EQ(probe().faceSize, 128);
  EXPECT_EQ(counters().facesCaptured - before, 6u);
  auto* bounces = named<QComboBox>("bounces");
  choose(bounces, bounces->findData(2));
  EXPECT_EQ(probe().bounces, 2);
  // The first of two lacks the light of the sky, which comes with lattices: it is not the one there was.
  EXPECT_EQ(counters().facesCaptured - before, 18u);
}

TEST_F(ProbePanelTest, AnInfluenceBoxOfItsOwnStartsAsTheBox) {
  QTest::mouseClick(named<QCheckBox>("influence"), Qt::LeftButton, {}, QPoint(8, 8));
  ASSERT_TRUE(probe().influence);
  EXPECT_TRUE(*probe().influence == probe().box);
  type(row("boxMax")->field(0), "3");
  EXPECT_EQ(probe().influence->max.x, 1.5) << "a box of its own must not follow";
  QTest::mouseClick(named<QCheckBox>("influence"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_FALSE(probe().influence);
}

}  // namespace
}  // namespace boxprobe
