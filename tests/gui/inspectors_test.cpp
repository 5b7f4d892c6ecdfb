// The three inspectors: their headings, which page is shown when, and how their tabs read.
#include "app/gui/window/inspectors.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTreeView>
#include <set>

#include "app/gui/edit/view_state.h"
#include "app/gui/panels/outliner.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/value_field.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

using Kind = OutlinerModel::Kind;

class InspectorsTest : public WindowTest {
 protected:
  void TearDown() override { window_->viewState().forget(); }
  QTabWidget* tabs() const { return window_->findChild<QTabWidget*>("inspectors"); }
  std::string page() const { return tabs()->tabText(tabs()->currentIndex()).toStdString(); }
  std::string heading(const char* name) const { return window_->findChild<QLabel*>(name)->text().toStdString(); }
  void click(const QModelIndex& row) {
    ASSERT_TRUE(row.isValid());
    QTreeView* tree = window_->findChild<Outliner*>()->tree();
    tree->expand(row.parent());
    tree->scrollTo(row);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(row).center());
  }
  std::set<std::string> ownMaterials(const std::string& node) const {
    std::set<std::string> names;
    const Model& model = *window_->models().front();
    for (const Instance& each : model.instances) {
      const int material = model.meshes.at(static_cast<std::size_t>(each.mesh)).material;
      if (each.node == node && material >= 0) names.insert(model.materials.at(static_cast<std::size_t>(material)).name);
    }
    return names;
  }
  void keep(const char* name) {
    waitUntilIdle();
    if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
      window_->grab().save(QString("%1/%2.png").arg(folder, name));
    }
  }
};

TEST_F(InspectorsTest, EachIsHeadedByWhatIsSelected) {
  EXPECT_EQ(heading("probeName"), "room");
  EXPECT_EQ(heading("objectName"), "No object selected");
  EXPECT_EQ(heading("sceneName"), "building.boxprobe.json");
  keep("inspector-probe");
  document().selectProbe(std::nullopt);
  EXPECT_EQ(heading("probeName"), "No probe");
  document().selectProbe(0);
  window_->editor().commitProbe("Rename", [](Probe& probe) { probe.name = "hall"; });
  EXPECT_EQ(heading("probeName"), "hall");
  document().undo();
  EXPECT_EQ(heading("probeName"), "room");
  const OutlinerModel& model = window_->findChild<Outliner*>()->model();
  click(model.object("pillars"));
  EXPECT_EQ(heading("objectName"), "pillars");
  const auto* material = window_->findChild<QComboBox*>("material");
  EXPECT_NE(ownMaterials("pillars").count(material->currentText().toStdString()), 0u) << "its own is shown with it";
  window_->viewState().selectObjects({});
  EXPECT_EQ(heading("objectName"), "No object selected");
}

TEST_F(InspectorsTest, TheOutlinerTurnsThePageAndAClickInThePictureDoesNot) {
  const OutlinerModel& model = window_->findChild<Outliner*>()->model();
  EXPECT_EQ(page(), "Probe");
  const QPointF sphere = pixelOf({0.55, 0.85, -0.3});  // no handle lies there
  press(sphere);
  release(sphere);
  ASSERT_FALSE(window_->viewState().objects().empty());
  EXPECT_EQ(page(), "Probe") << "nobody asked for another";
  EXPECT_EQ(heading("objectName"), *window_->viewState().objects().begin());
  click(model.object("pillars"));
  EXPECT_EQ(page(), "Object");
  EXPECT_EQ(QApplication::focusWidget(), window_->findChild<Outliner*>()->tree()) << "the keys stay where they were";
  keep("inspector-object");
  click(model.index(0, 0, model.group(Kind::Lights)));
  EXPECT_EQ(page(), "Scene");
  keep("inspector-scene");
  click(model.probe(0));
  EXPECT_EQ(page(), "Probe");
  auto* scroll = tabs()->widget(0)->findChild<QScrollArea*>();
  scroll->verticalScrollBar()->setValue(120);
  click(model.object("pillars"));
  click(model.probe(0));
  EXPECT_EQ(scroll->verticalScrollBar()->value(), 120) << "it is found as it was left";
}

TEST_F(InspectorsTest, WithoutASceneThereAreHeadingsAndNoFields) {
  window_->showScene(LoadedScene());
  for (int i = 0; i < tabs()->count(); ++i) {
    tabs()->setCurrentIndex(i);
    const auto fields = tabs()->widget(i)->findChildren<ValueField*>();
    ASSERT_FALSE(fields.empty());
    for (const ValueField* field : fields) EXPECT_FALSE(field->isVisible());
  }
  for (const char* name : {"probeName", "objectName", "sceneName"}) EXPECT_EQ(heading(name), "No scene");
  keep("inspector-empty");
  window_->showScene(scene());
  tabs()->setCurrentIndex(0);
  EXPECT_TRUE(tabs()->widget(0)->findChild<ValueField*>()->isVisibleTo(tabs()));
}

// Of the docks, too, in the smallest window.
TEST_F(InspectorsTest, TabsReadHorizontallyAndWhole) {
  window_->resize(1024, 700);
  waitUntilIdle();
  int seen = 0;
  const auto bars = window_->findChildren<QTabBar*>();
  for (const QTabBar* bar : bars) {
    if (!bar->isVisible()) continue;
    EXPECT_TRUE(bar->shape() == QTabBar::RoundedNorth || bar->shape() == QTabBar::RoundedSouth ||
                bar->shape() == QTabBar::TriangularNorth || bar->shape() == QTabBar::TriangularSouth);
    for (int i = 0; i < bar->count(); ++i) {
      const QRect tab = bar->tabRect(i);
      const QString text = bar->tabText(i);
      EXPECT_GE(tab.width(), bar->fontMetrics().horizontalAdvance(text)) << text.toStdString();
      EXPECT_GE(tab.left(), 0) << text.toStdString();
      EXPECT_LT(tab.right(), bar->width()) << text.toStdString();
      ++seen;
    }
  }
  EXPECT_GE(seen, 9) << "three inspectors, six docks";
  keep("inspector-small");
}

}  // namespace
}  // namespace boxprobe
