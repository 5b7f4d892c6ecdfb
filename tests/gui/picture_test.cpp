// The picture itself: boxes and reflections on and off, and exported images without the handles.
#include <gtest/gtest.h>

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/view/viewport.h"
#include "app/gui/widgets/axis_colors.h"
#include "app/gui/window/file_commands.h"
#include "filters/io/image/image_file.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class PictureTest : public WindowTest {
 protected:
  QImage shown() const { return shownPicture(window_->viewport()); }
  int boxPixels() const {
    const Box& box = probe().box;
    const glm::dvec3 a(box.min.x, box.min.y, box.min.z);
    const glm::dvec3 b(box.max.x, box.min.y, box.min.z);
    constexpr double kRadius = 3.0;
    constexpr int kTolerance = 40;
    return pixelsNear(shown(), pixelOf(a), pixelOf(b), kRadius, boxColor(), kTolerance);
  }
};

TEST_F(PictureTest, TheBoxIsDrawnWhereItIs) {
  EXPECT_GT(boxPixels(), 200);
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.min = glm::dvec3(-2.0, 0.5, -2.0); });
  waitUntilIdle();
  EXPECT_GT(boxPixels(), 100);
}

TEST_F(PictureTest, BoxesCanBeHiddenAndThenNothingCanBeTakenHoldOf) {
  const QPointF handle = facePixel({0, true});
  key(Qt::Key_B, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_LT(boxPixels(), 20);
  drag(handle, handle + QPointF(40, 0));
  EXPECT_FALSE(document().canUndo());
  key(Qt::Key_B, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_FALSE(document().canUndo());
}

TEST_F(PictureTest, ReflectionsCanBeSwitchedOffAndOnAgain) {
  const QImage with = shown();
  const std::uint64_t faces = counters().facesCaptured;
  key(Qt::Key_R, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_GT(differingShare(with, shown()), 0.02);
  key(Qt::Key_R, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_LT(differingShare(with, shown()), 1e-3);
  EXPECT_EQ(counters().facesCaptured, faces);
}

TEST_F(PictureTest, AnExportedImageHasNoHandlesAndTheSizeShown) {
  QTemporaryDir folder;
  const QString path = folder.filePath("picture.png");
  const QImage before = shown();
  answerFileDialog(path);
  key(Qt::Key_E, Qt::ControlModifier);
  waitUntilIdle();
  const QImage exported = QImage(path).convertToFormat(QImage::Format_RGB32);
  ASSERT_FALSE(exported.isNull());
  EXPECT_LT(differingShare(before, shown()), 1e-4) << "the handles must be back";
  key(Qt::Key_B, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_LT(differingShare(exported, shown()), 1e-3) << "exported: what is shown without boxes";
  key(Qt::Key_B, Qt::ControlModifier);  // the window is shared
  waitUntilIdle();
}

TEST_F(PictureTest, AnExportedExrIsLinear) {
  QTemporaryDir folder;
  const QString path = folder.filePath("picture.exr");
  answerFileDialog(path);
  key(Qt::Key_E, Qt::ControlModifier);
  const ImageRgbaF image = loadHdrImage(path.toStdString());
  EXPECT_EQ(image.width, window_->viewport().width());
  EXPECT_EQ(image.height, window_->viewport().height());
  waitUntilIdle();
}

class EmptyWindowTest : public PictureTest {
 protected:
  LoadedScene scene() const override { return {}; }
};

TEST_F(EmptyWindowTest, SaysWhatToDoAndThenOpens) {
  EXPECT_TRUE(window_->windowTitle().startsWith("no scene"));
  bool invited = false;
  for (auto* label : window_->viewport().findChildren<QWidget*>()) invited |= label->isVisible();
  EXPECT_TRUE(invited);
  EXPECT_TRUE(window_->files().openPath(QString::fromStdString(buildingPath())));
  EXPECT_EQ(document().scene().probes.size(), 1u);
}

}  // namespace
}  // namespace boxprobe
