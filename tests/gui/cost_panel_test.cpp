// The dock of run time against error: an earlier benchmark's points, the current choice among them, and measuring from
// the window as a process that can be stopped.
#include "app/gui/panels/cost_panel.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <cstdlib>

#include "filters/io/scene/scene_file.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

constexpr const char* kResults = R"({"summary": [
  {"reference": "box", "technique": "box+none", "label": "box", "frameCpuRatioToBox": 1.0, "error": 0.09, "onFront": true, "ours": false},
  {"reference": "box", "technique": "box+hdrp", "label": "hdrp", "frameCpuRatioToBox": 1.2, "error": 0.095, "onFront": false, "ours": false},
  {"reference": "box", "technique": "box+footprint4", "label": "footprint4", "frameCpuRatioToBox": 2.5, "error": 0.03, "onFront": true, "ours": true},
  {"reference": "scene", "technique": "box+none", "label": "box", "frameCpuRatioToBox": 1.0, "error": 0.2, "onFront": true, "ours": false}]})";

class CostPanelTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    panel_ = window_->findChild<CostPanel*>();
    dock_ = window_->findChild<QDockWidget*>("cost");
    ASSERT_NE(panel_, nullptr);
    dock_->show();
    dock_->raise();
    waitUntilIdle();
  }
  void TearDown() override {
    window_->findChild<QDockWidget*>("probes")->raise();
    WindowTest::TearDown();
  }
  /// The open scene under a name of its own, with results beside it if wanted.
  std::string openCopy(bool withResults) {
    const std::string path = folder_.filePath("copy.boxprobe.json").toStdString();
    saveSceneFile(window_->document().scene(), path);
    if (withResults) {
      const QString bench = QString::fromStdString(CostPanel::folderBeside(path));
      QDir().mkpath(bench);
      QFile file(bench + "/bench.json");
      EXPECT_TRUE(file.open(QIODevice::WriteOnly));
      file.write(kResults);
    }
    window_->showScene(loadScene(path, {}));
    waitUntilIdle();
    return path;
  }
  template <typename T>
  T* named(const char* name) {
    return panel_->findChild<T*>(name);
  }

  CostPanel* panel_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QTemporaryDir folder_;
};

TEST_F(CostPanelTest, ShowsAnEarlierBenchmarkAndTheCurrentChoice) {
  openCopy(true);
  auto* table = named<QTreeWidget>("costTable");
  ASSERT_EQ(table->topLevelItemCount(), 3) << "against the box alone";
  EXPECT_EQ(table->topLevelItem(0)->text(0), "footprint4") << "the least error first";
  const auto selected = table->selectedItems();
  ASSERT_EQ(selected.size(), 1);
  EXPECT_EQ(selected.front()->text(0), "box");
  const auto* chart = panel_->findChild<QLabel*>("costChart");
  EXPECT_TRUE(QTest::qWaitFor([chart] { return !chart->pixmap(Qt::ReturnByValue).isNull(); }, 60000));
  waitUntilIdle();
  const QImage dark = chart->pixmap(Qt::ReturnByValue).toImage();
  EXPECT_LT(dark.pixelColor(2, 2).lightness(), 60) << "as dark as the window";
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT"))
    window_->grab().save(QString(folder) + "/cost_panel.png");

  // A row's double click chooses it, as one step.
  emit table->itemDoubleClicked(table->topLevelItem(0), 0);
  EXPECT_EQ(probe().technique, "footprint4");
  ASSERT_EQ(table->selectedItems().size(), 1);
  EXPECT_EQ(table->selectedItems().front()->text(0), "footprint4");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(probe().technique, "box");
}

TEST_F(CostPanelTest, MeasuresBesideTheWindowAndStops) {
  const std::string path = openCopy(false);
  EXPECT_GT(named<QTreeWidget>("costTable")->topLevelItemCount(), 10) << "what comes with the program";
  EXPECT_TRUE(named<QLabel>("help")->text().contains("example scene")) << "marked as such";
  panel_->setProgram(BOXPROBE_PROGRAM);
  auto* quick = named<QPushButton>("measureQuickly");
  ASSERT_TRUE(quick->isEnabled());
  QTest::mouseClick(quick, Qt::LeftButton);
  EXPECT_TRUE(panel_->measuring());
  EXPECT_FALSE(quick->isEnabled());
  EXPECT_TRUE(waitFor([this] { return !panel_->measuring() || named<QProgressBar>("costProgress")->value() >= 1; }));
  EXPECT_TRUE(panel_->measuring()) << "it says how far it is before it is done";
  EXPECT_GE(named<QProgressBar>("costProgress")->value(), 1);
  QTest::mouseClick(named<QPushButton>("stopMeasuring"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([this] { return !panel_->measuring(); }));
  EXPECT_TRUE(quick->isEnabled());
  // Edited: a copy of what is on show is measured, not the file.
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x += 0.5; });
  ASSERT_TRUE(quick->isEnabled());
  QTest::mouseClick(quick, Qt::LeftButton);
  EXPECT_FALSE(panel_->measuredScene().startsWith(folder_.path())) << panel_->measuredScene().toStdString();
  EXPECT_TRUE(loadSceneFile(panel_->measuredScene().toStdString()).probes == document().scene().probes);
  // Saved under another name it is the same scene: the measurement goes on, and its results are shown.
  const QString measured = panel_->measuredScene();
  document().markSaved(folder_.filePath("other.boxprobe.json").toStdString());
  EXPECT_TRUE(panel_->measuring());
  ASSERT_TRUE(QFile::exists(measured));
  const QString bench = QFileInfo(measured).absolutePath() + "/bench";
  QDir().mkpath(bench);
  QFile file(bench + "/bench.json");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(kResults);
  file.close();
  QTest::mouseClick(named<QPushButton>("stopMeasuring"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([this] { return !panel_->measuring(); }));
  EXPECT_FALSE(QFile::exists(QString::fromStdString(CostPanel::folderBeside(path)) + "/bench.json"));
  EXPECT_EQ(named<QTreeWidget>("costTable")->topLevelItemCount(), 3);
  document().markSaved(folder_.filePath("third.boxprobe.json").toStdString());
  EXPECT_EQ(named<QTreeWidget>("costTable")->topLevelItemCount(), 3);
  // Another scene.
  openCopy(false);
  EXPECT_GT(named<QTreeWidget>("costTable")->topLevelItemCount(), 10);
  EXPECT_FALSE(QFile::exists(measured));
}

}  // namespace
}  // namespace boxprobe
