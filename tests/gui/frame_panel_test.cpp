// The dock that says what a frame does: its numbers are those of the picture, and an object's mode can be set in it.
#include "app/gui/panels/frame_panel.h"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <cstdlib>
#include <set>

#include "app/gui/widgets/quiet_combo.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class FramePanelTest : public WindowTest {
 protected:
  /// Maps large enough that two places tell MiB from MB.
  LoadedScene scene() const override { return smallBuilding({"probes.room.faceSize=64"}); }
  void SetUp() override {
    WindowTest::SetUp();
    size_ = window_->size();
    window_->resize(size_ / 2);  // costs are measured by some hundred frames
    dock_ = window_->findChild<QDockWidget*>("frame");
    ASSERT_NE(dock_, nullptr);
    dock_->show();
    dock_->raise();
    waitUntilIdle();
    tree_ = window_->findChild<QTreeWidget*>("frameTree");
    QTest::qWait(50);
    ASSERT_TRUE(QTest::qWaitFor([this] { return tree_->isVisible() && section("Draws") != nullptr; }, 60000));
  }
  void TearDown() override {
    window_->findChild<QDockWidget*>("probes")->raise();
    window_->resize(size_);
    waitUntilIdle();
    WindowTest::TearDown();
  }
  QTreeWidgetItem* find(QTreeWidgetItem* parent, const QString& name) const {
    for (int i = 0; i < parent->childCount(); ++i) {
      if (parent->child(i)->text(0) == name) return parent->child(i);
    }
    return nullptr;
  }
  QTreeWidgetItem* section(const QString& title) const { return tree_->findItems(title, Qt::MatchExactly).value(0); }

  QSize size_;
  QDockWidget* dock_ = nullptr;
  QTreeWidget* tree_ = nullptr;
};

// Afterwards the picture is whole again.
TEST_F(FramePanelTest, CostsAreMeasuredOnAButton) {
  const QImage before = shownPicture(window_->viewport());
  window_->findChild<QPushButton*>("measureCosts")->click();
  QTreeWidgetItem* costs = section("Costs of the frame");
  ASSERT_NE(costs, nullptr);
  for (const char* part : {"reflection", "light loop", "output", "window"})
    EXPECT_NE(find(costs, part), nullptr) << part;
  // Which objects are among the sixteen that are measured one by one is up to their programs.
  const QTreeWidgetItem* objects = section("Costs of objects' pixels");
  ASSERT_NE(objects, nullptr);
  EXPECT_EQ(objects->childCount(), 16);
  std::set<QString> nodes;
  for (const auto& object : window_->models().front()->instances) nodes.insert(QString::fromStdString(object.node));
  for (int i = 0; i < objects->childCount(); ++i) {
    EXPECT_EQ(nodes.erase(objects->child(i)->text(0)), 1u)
        << "a name of the model, once: " << objects->child(i)->text(0).toStdString();
  }
  waitUntilIdle();
  EXPECT_EQ(differingShare(shownPicture(window_->viewport()), before, 1), 0.0);
}

TEST_F(FramePanelTest, CountsAreThePictures) {
  QTreeWidgetItem* draws = section("Draws");
  ASSERT_NE(draws, nullptr);
  const auto& counted = counters().drawsByProbeCount;
  EXPECT_EQ(find(draws, "with 0 probes")->text(1), QString::number(counted[0]));
  EXPECT_EQ(find(draws, "with 1 probe")->text(1), QString::number(counted[1]));
  QTreeWidgetItem* memory = find(section("Memory by probe"), "room");
  ASSERT_NE(memory, nullptr);
  std::size_t bytes = 0;
  for (const auto& held : window_->renderer().frameReport().probes) bytes += held.name == "room" ? held.bytes : 0;
  EXPECT_GT(bytes, 0u);
  const QString shown = QString::number(static_cast<double>(bytes) / (1 << 20), 'f', 2);
  ASSERT_NE(shown, QString::number(static_cast<double>(bytes) / 1.0e6, 'f', 2));
  EXPECT_EQ(memory->text(1), shown + " MiB");
  QTreeWidgetItem* ball = find(section("Objects and their probes"), "sphere 9");
  ASSERT_NE(ball, nullptr);
  EXPECT_NE(find(ball, "room"), nullptr);
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
    ball->setSelected(true);
    window_->grab().save(QString::fromUtf8(folder) + "/frame_dock.png");
  }
}

TEST_F(FramePanelTest, LookupsAreCountedAndShown) {
  QTest::mouseClick(window_->findChild<QPushButton*>("countLookups"), Qt::LeftButton);
  const QString text = window_->findChild<QLabel*>("frameSummary")->text();
  EXPECT_TRUE(text.contains("mean")) << text.toStdString();
  QPushButton* heatMap = window_->findChild<QPushButton*>("heatMap");
  QTest::mouseClick(heatMap, Qt::LeftButton);
  waitUntilIdle();
  EXPECT_TRUE(heatMap->isChecked());
  QTest::mouseClick(heatMap, Qt::LeftButton);
  waitUntilIdle();
}

TEST_F(FramePanelTest, AnObjectsProbesAreChosenHere) {
  find(section("Objects and their probes"), "sphere 9")->setSelected(true);
  auto* mode = dynamic_cast<QuietCombo*>(window_->findChild<QComboBox*>("probeMode"));
  ASSERT_NE(mode, nullptr);
  ASSERT_TRUE(mode->isVisible());
  mode->setCurrentIndex(0);
  emit mode->activated(0);
  waitUntilIdle();
  EXPECT_EQ(document().scene().objects.at("sphere 9").probeUsage, ProbeUsage::Off);
  QTreeWidgetItem* ball = find(section("Objects and their probes"), "sphere 9");
  EXPECT_EQ(find(ball, "room"), nullptr);
  EXPECT_EQ(find(ball, "sky")->text(1), "100 %");
  document().undo();
  waitUntilIdle();
  EXPECT_NE(find(find(tree_->invisibleRootItem(), "Objects and their probes"), "sphere 9"), nullptr);
}

}  // namespace
}  // namespace boxprobe
