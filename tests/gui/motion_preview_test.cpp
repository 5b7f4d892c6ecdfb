// Cheaper techniques while something moves, and means of frames while nothing does, by real events.
#include "app/gui/view/motion_preview.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/axis_colors.h"
#include "app/gui/widgets/preferences.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class MotionPreviewTest : public WindowTest {
 protected:
  LoadedScene scene() const override {
    return smallBuilding(
        {"probes.room.technique=footprint16", "materials.sphere.roughness=0.4", "materials.mirror.roughness=0.4"});
  }
  void SetUp() override {
    WindowTest::SetUp();
    window_->motionPreview().setEnabled(true);
    waitUntilIdle();
  }
  void TearDown() override {
    window_->motionPreview().setEnabled(true);
    window_->motionPreview().setRest(MotionPreview::kRestMilliseconds);
  }
  /// Until it is let go or setRest is called again: drawing slowly is not holding still.
  void neverRest() { window_->motionPreview().setRest(24 * 3600 * 1000); }

  QString pictureState() const {
    const auto* label = window_->findChild<QLabel*>("pictureState");
    return label->isVisible() ? label->text() : QString();
  }
  std::uint64_t renders() const { return window_->scheduler().renders(); }
  QImage shown() const { return shownPicture(window_->viewport()); }
  QImage shownWithoutPreview() {
    window_->motionPreview().setEnabled(false);
    window_->scheduler().requestRender();
    waitUntilIdle();
    return shown();
  }
};

TEST_F(MotionPreviewTest, AMovingCameraShowsTheCheaperPictureAndOneRenderBringsTheFullOneBack) {
  const std::uint64_t programs = counters().programsCompiled;
  const QPointF from(30, 30);
  neverRest();
  press(from);
  for (int i = 1; i <= 4; ++i) move(from + QPointF(6 * i, 2 * i));
  EXPECT_TRUE(window_->motionPreview().active());
  EXPECT_TRUE(pictureState().contains("preview")) << pictureState().toStdString();
  const QImage moving = shown();
  const std::uint64_t before = renders();
  window_->motionPreview().setRest(MotionPreview::kRestMilliseconds);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window_->motionPreview().active(); }, 60000));
  waitUntilIdle();
  EXPECT_EQ(renders(), before + 1) << "still, though the button is held";
  EXPECT_EQ(pictureState(), "");
  release(from + QPointF(24, 8));
  waitUntilIdle();
  const QImage rest = shown();
  EXPECT_GT(differingShare(moving, rest, 2), 1e-3) << "a floor and balls of roughness 0.4";
  EXPECT_EQ(counters().programsCompiled, programs) << "made ready before the hand moved";
  EXPECT_EQ(differingShare(shownWithoutPreview(), rest), 0.0);
}

TEST_F(MotionPreviewTest, ADraggedFaceComesToRestWhenItIsLetGo) {
  const std::uint64_t programs = counters().programsCompiled;
  const QPointF handle = facePixel({0, true});
  neverRest();
  move(handle);
  press(handle);
  for (int i = 1; i <= 4; ++i) move(handle + QPointF(-5 * i, 0));
  EXPECT_TRUE(window_->motionPreview().active());
  EXPECT_TRUE(pictureState().contains("preview"));
  release(handle + QPointF(-20, 0));
  EXPECT_FALSE(window_->motionPreview().active());
  waitUntilIdle();
  EXPECT_EQ(pictureState(), "");
  const QImage rest = shown();
  EXPECT_LE(counters().programsCompiled, programs + 1) << "the moved box may leave an object its own variant";
  EXPECT_EQ(differingShare(shownWithoutPreview(), rest), 0.0);
}

TEST_F(MotionPreviewTest, IsSwitchedInTheMenuAndRemembered) {
  window_->motionPreview().setEnabled(false);
  EXPECT_EQ(cheaperWhileMoving(), std::optional<bool>(false));
  waitUntilIdle();
  press({30, 30});
  move({40, 34});
  move({50, 38});
  EXPECT_FALSE(window_->motionPreview().active());
  EXPECT_EQ(pictureState(), "");
  release({50, 38});
  waitUntilIdle();
  window_->motionPreview().setEnabled(true);
  EXPECT_EQ(cheaperWhileMoving(), std::optional<bool>(true));
}

class CheapTechniqueTest : public MotionPreviewTest {
 protected:
  LoadedScene scene() const override { return smallBuilding(); }
};

TEST_F(CheapTechniqueTest, NothingStandsInForACheapTechnique) {
  press({30, 30});
  move({40, 34});
  EXPECT_FALSE(window_->motionPreview().active());
  const std::uint64_t before = renders();
  release({40, 34});
  QTest::qWait(400);
  EXPECT_EQ(renders(), before) << "no second picture of the same thing";
}

TEST_F(CheapTechniqueTest, AtRestProgramsAreMadeForTheSceneAsItIsAndThePictureStays) {
  const QImage before = shown();
  const auto folded = counters().constantsFolded;
  QTest::qWait(100);
  EXPECT_EQ(counters().constantsFolded, folded) << "not before the rest is over";
  window_->pictureWork().setRest(0);
  EXPECT_TRUE(waitFor([&] { return counters().constantsFolded > folded; }));
  waitUntilIdle();
  window_->pictureWork().setRest(kNeverMilliseconds);
  EXPECT_EQ(differingShare(before, shown(), 1), 0.0);
}

TEST_F(CheapTechniqueTest, FramesAreAveragedWhileNothingMovesUntilThereAreEnough) {
  window_->editor().commitProbe("Set technique", [](Probe& p) {
    p.technique = "raytraced";
    p.parameters = {{"samples", 1.0}, {"animated", true}};
  });
  const auto averaged = [this] { return window_->renderer().frameCount().averaged; };
  ASSERT_TRUE(waitFor([&] { return averaged() >= 5; }));
  EXPECT_EQ(pictureState(), QString("%1 of 1024 frames averaged").arg(averaged()));
  // Handles and boxes lie on top of the mean as ever.
  const Box& box = probe().box;
  const glm::dvec3 a(box.min.x, box.min.y, box.min.z), b(box.max.x, box.min.y, box.min.z);
  EXPECT_GT(pixelsNear(shown(), pixelOf(a), pixelOf(b), 3.0, boxColor(), 40), 100);

  window_->editor().commitProbe("Set samples", [](Probe& p) { p.parameters["samples"] = 2.0; });
  ASSERT_TRUE(waitFor([&] { return averaged() == 1; })) << "an edit begins the mean anew";
  window_->editor().commitProbe("Still", [](Probe& p) { p.parameters["animated"] = false; });
  waitUntilIdle();
  EXPECT_EQ(pictureState(), "");
  const std::uint64_t before = renders();
  QTest::qWait(100);
  EXPECT_EQ(renders(), before) << "an idle window draws nothing";
}

}  // namespace
}  // namespace boxprobe
