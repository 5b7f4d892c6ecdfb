// Objects placed, said to move, and made planar mirrors: live, one step each, and nothing is captured for it.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QTest>

#include "app/gui/explain/debug_view.h"
#include "app/gui/explain/mirror_lines.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/vector_row.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class ObjectPanelTest : public WindowTest {
 protected:
  void choose(const QString& node) {
    auto* nodes = window_->findChild<QComboBox*>("object");
    ASSERT_GE(nodes->findText(node), 0) << node.toStdString();
    nodes->setCurrentIndex(nodes->findText(node));
    emit nodes->activated(nodes->currentIndex());
  }
  QCheckBox* box(const char* name) const { return window_->findChild<QCheckBox*>(name); }
};

TEST_F(ObjectPanelTest, AMovingObjectShowsInAPlanarMirror) {
  choose("pillars");
  EXPECT_FALSE(box("planarMirror")->isEnabled()) << "pillars are not flat";
  EXPECT_FALSE(window_->findChild<QLabel*>("mirrorProblem")->text().isEmpty());
  choose("sphere 9");
  box("dynamic")->click();
  EXPECT_TRUE(document().scene().objects.at("sphere 9").dynamic);
  choose("mirror");
  ASSERT_TRUE(box("planarMirror")->isEnabled());
  waitUntilIdle();
  EXPECT_EQ(counters().mirrors.drawn, 0u);
  box("planarMirror")->click();
  waitUntilIdle();
  EXPECT_TRUE(document().scene().mirrors.at("mirror").enabled);
  EXPECT_EQ(counters().mirrors.drawn, 1u);
  EXPECT_EQ(document().undoLabel(), "Make mirror a mirror");

  // Dragged, it is seen at once and nothing is captured.
  choose("sphere 9");
  const std::uint64_t faces = counters().facesCaptured;
  const QImage before = shownPicture(window_->viewport());
  ValueField* height = window_->findChild<VectorRow*>("objectPosition")->field(1);
  height->scrubTo(0.6);
  EXPECT_TRUE(document().previewing());
  const auto changed = [&] { return differingShare(before, shownPicture(window_->viewport())) > 0.002; };
  EXPECT_TRUE(QTest::qWaitFor(changed, 60000));
  height->endScrub();
  EXPECT_FALSE(document().previewing());
  waitUntilIdle();
  EXPECT_EQ(document().scene().objects.at("sphere 9").translation.y, 0.6);
  EXPECT_EQ(document().undoLabel(), "Move sphere 9");
  EXPECT_EQ(counters().facesCaptured, faces);
  EXPECT_EQ(counters().mirrors.drawn, 1u);

  box("mirrorsShown")->click();
  waitUntilIdle();
  EXPECT_EQ(window_->debugView().mirrorLines().lines(), 9u) << "four edges, four rays, the mirrored eye";
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
    window_->grab().save(QString::fromUtf8(folder) + "/object_panel.png");
    shownPicture(window_->viewport()).save(QString::fromUtf8(folder) + "/mirror_lines.png");
  }
  box("mirrorsShown")->click();
  document().undo();
  document().undo();
  waitUntilIdle();
  EXPECT_EQ(counters().mirrors.drawn, 0u);
}

}  // namespace
}  // namespace boxprobe
