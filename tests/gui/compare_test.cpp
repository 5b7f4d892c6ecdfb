// Comparison: the divider, the number, the reference in the background, and what ends it.
#include <gtest/gtest.h>

#include <QLabel>
#include <QStatusBar>
#include <QTest>

#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/view_tools.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class CompareTest : public WindowTest {
 protected:
  void TearDown() override { compare().stop(); }
  PictureCompare& compare() { return window_->tools().compare(); }
  CompareWipe& wipe() { return *window_->findChild<CompareWipe*>("compare"); }
  QString numbers() { return window_->findChild<QLabel*>("compareNumbers")->text(); }
  QString caption() { return window_->findChild<QLabel*>("compareRight")->text(); }
  /// What is over the picture, away from its labels and corners.
  QImage shown() {
    const QPoint corner = window_->viewport().mapTo(window_, QPoint(0, 0));
    const QRect inner(20, 160, wipe().width() / 2, wipe().height() - 260);
    return window_->grab().toImage().copy(inner.translated(corner));
  }
  bool measured() {
    return QTest::qWaitFor([this] { return !numbers().isEmpty(); }, 300000);
  }
};

TEST_F(CompareTest, AHeldPictureStandsBesideWhatIsChanged) {
  key(Qt::Key_C);
  EXPECT_TRUE(compare().active());
  ASSERT_TRUE(measured());
  EXPECT_EQ(numbers(), "No difference");
  wipe().setDivider(0.75);
  const QImage before = window_->grab().toImage();
  window_->editor().commitProbe("Set technique", [](Probe& edited) { edited.technique = "infinite"; });
  waitUntilIdle();
  EXPECT_TRUE(QTest::qWaitFor([this] { return numbers().contains("PSNR"); }, 60000)) << numbers().toStdString();
  // Right of the divider the picture is as it was, left of it it is not.
  const QImage now = window_->grab().toImage();
  const int line = static_cast<int>(0.75 * wipe().width());
  const QRect right(line + 20, 160, wipe().width() - line - 40, wipe().height() - 260);
  const QPoint corner = window_->viewport().mapTo(window_, QPoint(0, 0));
  const auto part = [&](const QImage& image) { return image.copy(right.translated(corner)); };
  EXPECT_EQ(differingShare(part(before), part(now)), 0.0);
  const QRect left(20, 160, line - 40, wipe().height() - 260);
  EXPECT_GT(differingShare(before.copy(left.translated(corner)), now.copy(left.translated(corner))), 0.001);
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) window_->grab().save(QString(folder) + "/wipe.png");
  key(Qt::Key_V);
  EXPECT_TRUE(wipe().flipped());
  key(Qt::Key_V);
  EXPECT_FALSE(wipe().flipped());
  wipe().setDivider(0.5);
  key(Qt::Key_Escape);
  EXPECT_FALSE(compare().active());
  EXPECT_FALSE(wipe().isVisible());
}

TEST_F(CompareTest, TheDividerIsDraggedAndTheCameraStays) {
  key(Qt::Key_C);
  const Camera before = window_->renderer().currentCamera();
  const QPointF middle(0.5 * wipe().width(), 200.0);
  dragOver(&window_->viewport(), middle, middle + QPointF(-0.25 * wipe().width(), 0.0));
  EXPECT_NEAR(wipe().divider(), 0.25, 0.02);
  EXPECT_TRUE(window_->renderer().currentCamera() == before);
  EXPECT_FALSE(document().canUndo());
  wipe().setDivider(0.5);
}

TEST_F(CompareTest, AnotherViewHidesWhatIsHeldUntilOneIsBack) {
  key(Qt::Key_C);
  key(Qt::Key_2, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_FALSE(wipe().isVisible());
  key(Qt::Key_Home);
  waitUntilIdle();
  EXPECT_TRUE(wipe().isVisible());
}

TEST_F(CompareTest, TheReferenceComesInTheBackgroundAndCanBeStopped) {
  key(Qt::Key_C, Qt::ShiftModifier);
  EXPECT_TRUE(compare().tracing());
  EXPECT_TRUE(measured()) << "a coarse one comes first";
  EXPECT_TRUE(numbers().contains("PSNR"));
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT"))
    window_->grab().save(QString(folder) + "/reference.png");
  key(Qt::Key_Escape);
  EXPECT_FALSE(compare().tracing());
  EXPECT_FALSE(compare().active());
}

TEST_F(CompareTest, TheDifferenceIsAPictureOfFalseColoursWithAScale) {
  key(Qt::Key_C);
  ASSERT_TRUE(measured());
  key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(compare().difference());
  wipe().setDivider(0.0);
  waitUntilIdle();
  ASSERT_TRUE(QTest::qWaitFor([this] { return caption() == "Difference: Held"; }, 60000)) << caption().toStdString();
  EXPECT_EQ(numbers(), "No difference");
  const QImage dark = shown();
  EXPECT_LT(qGray(dark.pixel(dark.rect().center())), 8) << "no difference is black";
  window_->editor().commitProbe("Set technique", [](Probe& edited) { edited.technique = "infinite"; });
  waitUntilIdle();
  ASSERT_TRUE(QTest::qWaitFor([this] { return numbers().contains("mean"); }, 60000)) << numbers().toStdString();
  EXPECT_GT(differingShare(dark, shown()), 0.02);
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT"))
    window_->grab().save(QString(folder) + "/difference.png");
  key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(compare().difference());
  EXPECT_EQ(caption(), "Held");
  wipe().setDivider(0.5);
}

// Each says what it is; with all light a mirror in a mirror is not black.
TEST_F(CompareTest, AllLightOrTheReflectionIsTraced) {
  const auto traced = [this](const char* name) {
    return waitFor([&] { return caption() == name || caption().startsWith(QString(name) + ", "); });
  };
  compare().traceReference(TracedLight::Reflection);
  EXPECT_TRUE(traced("Reflection traced")) << caption().toStdString();
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains("reflection ray traced"));
  compare().traceReference(TracedLight::All);
  EXPECT_TRUE(traced("Path traced")) << caption().toStdString();
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains("All light"));
  wipe().setDivider(0.0);
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
    QTest::qWait(20000);
    window_->grab().save(QString(folder) + "/all-light.png");
  }
  key(Qt::Key_Escape);
  EXPECT_FALSE(compare().tracing());
  wipe().setDivider(0.5);
}

TEST_F(CompareTest, TheErrorAgainstTheTracedSceneGetsFinerAndFollowsTheView) {
  key(Qt::Key_V, Qt::ShiftModifier);
  EXPECT_TRUE(compare().tracing());
  EXPECT_TRUE(compare().difference());
  const auto percent = [this] {
    const QString text = caption();
    if (text == "Difference: Path traced") return 100;
    return text.startsWith("Difference: Path traced, ") ? text.mid(25).section(' ', 0, 0).toInt() : 0;
  };
  ASSERT_TRUE(waitFor([&] { return percent() > 0; })) << caption().toStdString();
  const int coarse = percent();
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
    window_->grab().save(QString(folder) + "/error-coarse.png");
  }
  EXPECT_TRUE(waitFor([&] { return percent() > coarse; })) << caption().toStdString();
  EXPECT_TRUE(numbers().contains("mean"));
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) window_->grab().save(QString(folder) + "/error.png");
  // Another view: what was traced is not shown over it, and it is traced anew.
  key(Qt::Key_2, Qt::ControlModifier);
  EXPECT_TRUE(waitFor([&] { return percent() == 0; })) << caption().toStdString();
  EXPECT_TRUE(compare().tracing());
  EXPECT_TRUE(waitFor([&] { return percent() > 0; })) << caption().toStdString();
  key(Qt::Key_Escape);
  EXPECT_FALSE(compare().tracing());
  EXPECT_FALSE(compare().difference());
}

}  // namespace
}  // namespace boxprobe
