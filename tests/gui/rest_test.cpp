// A view that rests in the window: what its mirrors get, and how soon they give it back.
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/rest_refinement.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/file_commands.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/maps/probe_maps.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class RestTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    enabled_ = window_->refinement().enabled();
    window_->refinement().setEnabled(true);
    window_->refinement().setRest(40);
  }
  void TearDown() override {
    window_->refinement().setRest(kNeverMilliseconds);
    window_->refinement().setEnabled(enabled_);
  }
  const SceneRenderer& renderer() const { return window_->renderer(); }
  int texels() const {
    const auto maps = renderer().shownMaps("room");
    return maps ? maps->radiance.faceSize() : 0;
  }
  bool rested() {
    return waitFor([this] {
      return window_->refinement().active() && window_->scheduler().idle() && !renderer().workPending() &&
             !renderer().frameCount().more();
    });
  }

 private:
  bool enabled_ = false;
};

TEST_F(RestTest, MirrorsAreSharperAndGiveItBack) {
  ASSERT_EQ(texels(), 32);
  ASSERT_TRUE(rested());
  EXPECT_EQ(texels(), 128);  // four times as many a side, and not as many as the window's pixels
  const std::size_t memory = renderer().probeMemoryBytes();
  const auto captured = counters().facesCaptured;

  window_->refinement().setRest(kNeverMilliseconds);
  window_->pictureWork().showCamera(1);
  EXPECT_FALSE(window_->refinement().active());
  EXPECT_EQ(texels(), 32);  // in that frame already
  EXPECT_LT(renderer().probeMemoryBytes(), memory);
  waitUntilIdle();
  EXPECT_EQ(counters().facesCaptured, captured);  // nothing is captured for it

  // Again, and an edit in place of a move.
  window_->refinement().setRest(40);
  window_->pictureWork().showCamera(0);
  ASSERT_TRUE(rested());
  EXPECT_EQ(texels(), 128);
  window_->refinement().setRest(kNeverMilliseconds);
  window_->pictureWork().setReflectionsShown(true);
  EXPECT_EQ(texels(), 32);
}

TEST_F(RestTest, FilesAreOfTheScenesOwnSize) {
  QTemporaryDir folder;
  const QString path = folder.filePath("copy.boxprobe.json");
  saveSceneFile(document().scene(), path.toStdString());
  ASSERT_TRUE(window_->files().openPath(path));
  ASSERT_TRUE(rested());
  ASSERT_EQ(texels(), 128);
  const auto question = answerMessageBox(QMessageBox::Save);
  window_->findChild<QToolButton*>("saveBaked")->click();
  EXPECT_TRUE(question->text.contains("copy.probes")) << question->text.toStdString();
  ASSERT_TRUE(waitFor([this] { return window_->statusBar()->currentMessage().startsWith("Wrote"); }));
  const BakedProbeFile file = loadBakedProbe(folder.filePath("copy.probes/room.exr").toStdString());
  EXPECT_EQ(file.maps.radiance.faceSize(), 32);
}

TEST_F(RestTest, SwitchedOffNothingIsSharper) {
  window_->refinement().setEnabled(false);
  emit window_->viewport().cameraMoved();
  waitUntilIdle();
  QTest::qWait(200);
  waitUntilIdle();
  EXPECT_EQ(texels(), 32);
  EXPECT_FALSE(window_->refinement().active());
}

}  // namespace
}  // namespace boxprobe
