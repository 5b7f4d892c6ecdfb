// The time at which a model's animations are shown: a slider that is there for models that have some, one undo step a
// drag, and a file that has gone meanwhile.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QSlider>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/window/file_commands.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_test.h"
#include "tests/unit/io_glb_builder.h"

namespace boxprobe {
namespace {

class AnimationTest : public WindowTest {
 protected:
  /// Two triangles, one of which goes 8 to the right within 4 seconds.
  void openMoving() {
    GlbBuilder glb;
    glb.triangle();
    glb.node({{"mesh", 0}});
    const int times = glb.floats("SCALAR", 1, {0, 4});
    glb.json["accessors"][static_cast<std::size_t>(times)]["min"] = {0};
    glb.json["accessors"][static_cast<std::size_t>(times)]["max"] = {4};
    const int moves = glb.floats("VEC3", 3, {0, 0, 0, 8, 0, 0});
    glb.json["animations"] = nlohmann::json::array(
        {{{"channels", nlohmann::json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})},
          {"samplers", nlohmann::json::array({{{"input", times}, {"output", moves}}})}}});
    QFile file(path());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    const std::string bytes = glb.glb();
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    ASSERT_TRUE(window_->files().openPath(path()));
    waitUntilIdle();
  }
  QString path() const { return QDir(folder_.path()).filePath("moving.glb"); }
  bool offered() { return window_->findChild<QToolBar*>("animation")->isVisible(); }
  QSlider* slider() { return window_->findChild<QSlider*>("animationTime"); }
  QString text() { return window_->findChild<QLabel*>("animationText")->text(); }
  double width() { return window_->renderer().bounds().size().x; }
  bool widthBecomes(double wanted) {
    return waitFor([&] { return std::abs(width() - wanted) < 1e-3; });
  }
  std::optional<double> time() { return document().scene().models.front().time; }

  QTemporaryDir folder_;
};

TEST_F(AnimationTest, TheSliderMovesWhatMoves) {
  EXPECT_FALSE(offered()) << "the building has none";
  openMoving();
  ASSERT_TRUE(offered());
  EXPECT_EQ(text(), "at rest / 4.00 s");
  const double still = width();
  const glm::dvec3 eye = window_->renderer().currentCamera().position;
  dragOver(slider(), {3.0, slider()->height() / 2.0}, {slider()->width() / 2.0, slider()->height() / 2.0});
  ASSERT_TRUE(time().has_value());
  EXPECT_NEAR(*time(), 2.0, 0.2);
  EXPECT_TRUE(widthBecomes(still + 2.0 * *time())) << width();
  EXPECT_EQ(document().stepLabels().size(), 1u) << "a drag is one step";
  EXPECT_EQ(document().undoLabel(), "Animation time");
  EXPECT_EQ(window_->renderer().currentCamera().position, eye) << "the view stays";
  const double seconds = *time();
  // While the handle is held the picture follows.
  slider()->setSliderDown(true);
  slider()->setSliderPosition(250);
  EXPECT_TRUE(widthBecomes(still + 2.0)) << width();
  EXPECT_EQ(document().stepLabels().size(), 1u);
  slider()->setSliderPosition(slider()->maximum() / 2);
  slider()->setSliderDown(false);
  EXPECT_TRUE(waitFor([&] { return document().stepLabels().size() == 2u; }));
  EXPECT_TRUE(widthBecomes(still + 4.0)) << width();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(widthBecomes(still + 2.0 * seconds));
  window_->findChild<QToolButton*>("animationRest")->click();
  EXPECT_TRUE(widthBecomes(still));
  EXPECT_FALSE(time().has_value());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(widthBecomes(still + 2.0 * seconds)) << "undo moves it, too";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(widthBecomes(still));
  EXPECT_EQ(text(), "at rest / 4.00 s");
  window_->showScene(smallBuilding());
  EXPECT_FALSE(offered());
  waitUntilIdle();
}

TEST_F(AnimationTest, AFileThatHasGoneIsSaidAndTheModelStays) {
  openMoving();
  const double still = width();
  ASSERT_TRUE(QFile::remove(path()));
  slider()->setValue(500);
  EXPECT_TRUE(waitFor([this] { return window_->statusBar()->currentMessage().contains("moving.glb"); }));
  EXPECT_NEAR(width(), still, 1e-6);
  window_->showScene(smallBuilding());
  waitUntilIdle();
}

}  // namespace
}  // namespace boxprobe
