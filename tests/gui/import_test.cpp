// A dropped model whose unit or up axis are doubtful: the question over the picture, its answer as one undo step, and
// no question where nothing is doubtful.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/view/import_bar.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/file_commands.h"
#include "data/scenes/glb_writer.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/window_test.h"
#include "tests/support/made_flat.h"

namespace boxprobe {
namespace {

class ImportTest : public WindowTest {
 protected:
  ImportBar* bar() { return window_->findChild<ImportBar*>("importBar"); }
  bool asked() { return bar()->isVisible(); }
  void click(const char* name) { QTest::mouseClick(window_->findChild<QPushButton*>(name), Qt::LeftButton); }
  void openFlat(double unitsPerMetre) {
    test::FlatWishes wishes;
    wishes.unitsPerMetre = unitsPerMetre;
    QFile file(QDir(folder_.path()).filePath("flat.glb"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    const std::string bytes = scenes::glbBytes(test::madeFlat(wishes));
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    ASSERT_TRUE(window_->files().openPath(file.fileName()));
    waitUntilIdle();
  }
  double width() { return window_->renderer().bounds().size().x; }
  const ModelFile& model() { return document().scene().models.front(); }

  QTemporaryDir folder_;
};

TEST_F(ImportTest, WhatIsInMetresAsksNothing) {
  openFlat(1.0);
  EXPECT_FALSE(asked());
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  window_->showScene(smallBuilding());
  EXPECT_FALSE(asked());
  waitUntilIdle();
}

TEST_F(ImportTest, CentimetresAreProposedAndTakenInOneStep) {
  openFlat(100.0);
  ASSERT_TRUE(asked());
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << "it waits; the window can be used";
  EXPECT_EQ(window_->findChild<QComboBox*>("importUnit")->currentText(), "centimetres");
  EXPECT_EQ(window_->findChild<QComboBox*>("importUp")->currentText(), "Y up");
  const double wide = width();
  EXPECT_GT(wide, 500.0);
  click("importApply");
  EXPECT_FALSE(asked());
  EXPECT_EQ(model().unit, LengthUnit::Centimetre);
  EXPECT_EQ(document().stepLabels().size(), 1u);
  EXPECT_EQ(document().undoLabel(), "Read in centimetres, Y up");
  EXPECT_NEAR(width(), wide / 100.0, 1e-3 * wide);
  ASSERT_FALSE(document().scene().probes.empty());
  EXPECT_LT(probe().box.size().y, 4.0);
  EXPECT_LT(glm::length(window_->renderer().currentCamera().position), 20.0) << "the view is in it, too";
  waitUntilIdle();
  EXPECT_TRUE(waitFor([this] { return window_->statusBar()->currentMessage().contains("; exposure "); }))
      << "found again";
  EXPECT_EQ(document().stepLabels().size(), 1u) << "within the step";

  const QString path = QDir(folder_.path()).filePath("flat.boxprobe.json");
  const auto dialog = answerFileDialog(path);
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(loadSceneFile(path.toStdString()).models.front().unit, LengthUnit::Centimetre);

  window_->editor().undo();
  EXPECT_EQ(model().unit, LengthUnit::Metre);
  EXPECT_NEAR(width(), wide, 1e-3 * wide);
  EXPECT_GT(probe().box.size().y, 100.0);
  waitUntilIdle();
}

TEST_F(ImportTest, WhoKeepsItIsNotAskedAgainButCanAsk) {
  openFlat(100.0);
  ASSERT_TRUE(asked());
  click("importKeep");
  EXPECT_FALSE(asked());
  EXPECT_FALSE(document().canUndo());
  for (const QMenu* menu : window_->findChildren<QMenu*>()) {
    for (QAction* action : menu->actions()) {
      if (action->text() == "&Unit and up axis...") action->trigger();
    }
  }
  ASSERT_TRUE(asked());
  EXPECT_EQ(window_->findChild<QComboBox*>("importUnit")->currentText(), "metres") << "as it is read now";
  auto* up = window_->findChild<QComboBox*>("importUp");
  up->setCurrentIndex(up->findText("Z up"));
  click("importApply");
  EXPECT_EQ(model().upAxis, UpAxis::Z);
  EXPECT_EQ(model().unit, LengthUnit::Metre);
  window_->editor().undo();
  EXPECT_EQ(model().upAxis, UpAxis::Y);
  window_->showScene(smallBuilding());
  waitUntilIdle();
}

}  // namespace
}  // namespace boxprobe
