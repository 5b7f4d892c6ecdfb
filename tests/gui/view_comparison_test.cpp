// Views side by side: each shows what is chosen for it with its error, the document stays as it is, and the picture is
// back when it ends.
#include "app/gui/view/view_comparison.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QElapsedTimer>
#include <QTest>
#include <algorithm>

#include "app/gui/view/viewport.h"
#include "app/gui/window/view_tools.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class ViewComparisonTest : public WindowTest {
 protected:
  // The box as it should be: what another technique costs is seen then.
  LoadedScene scene() const override {
    return loadScene(buildingPath(),
                     {"probes.room.faceSize=64", "probes.room.samplesPerPixel=1", "probes.room.bounces=1"});
  }
  void SetUp() override {
    WindowTest::SetUp();
    size_ = window_->size();
    window_->resize(size_ * 3 / 5);  // each view is drawn, traced and compared again and again
    waitUntilIdle();
  }
  void TearDown() override {
    views().setOn(false);
    window_->resize(size_);
    waitUntilIdle();
  }
  QSize size_;
  ViewComparison& views() { return window_->tools().sideBySide(); }
  QString numbers(int view) { return views().views().numbers(view); }
  bool made() {
    return waitFor([this] { return !views().making(); });
  }
  void choose(int view, const QString& id) {
    auto* combo = window_->findChild<QComboBox*>(QString("compareView%1").arg(view));
    combo->setFocus();
    const int wanted = combo->findData(id);
    ASSERT_GE(wanted, 0) << id.toStdString();
    while (combo->currentIndex() != wanted) key(combo->currentIndex() < wanted ? Qt::Key_Down : Qt::Key_Up);
    window_->viewport().setFocus();
  }
  /// The picture of one view, without the line under it.
  QImage shown(int view) {
    const QSize half(window_->viewport().width() / 2, window_->viewport().height() / 2);
    const QPoint corner = window_->viewport().mapTo(window_, QPoint(0, 0));
    const QRect part(QPoint((view % 2) * half.width() + 10, (view / 2) * half.height() + 10), half - QSize(20, 60));
    return window_->grab().toImage().copy(part.translated(corner));
  }
};

TEST_F(ViewComparisonTest, FourViewsShowWhatIsChosenWithTheirErrors) {
  const Scene before = document().scene();
  waitUntilIdle();
  const QImage picture = shownPicture(window_->viewport());
  key(Qt::Key_C, Qt::AltModifier);
  EXPECT_TRUE(views().on());
  EXPECT_TRUE(views().views().isVisible());
  ASSERT_TRUE(made());
  ASSERT_TRUE(waitFor([this] { return numbers(0).startsWith("Error") && numbers(2).startsWith("Error"); }))
      << numbers(0).toStdString() << numbers(1).toStdString();
  EXPECT_TRUE(numbers(3).startsWith("Error")) << numbers(3).toStdString();
  EXPECT_TRUE(numbers(1).contains("% traced")) << numbers(1).toStdString();
  // Once it is fine enough to tell them apart.
  const auto traced = [this] {
    return numbers(1).startsWith("The measure") ? 100 : numbers(1).section(' ', 0, 0).toInt();
  };
  ASSERT_TRUE(waitFor([&] { return traced() >= 60; })) << numbers(1).toStdString();
  EXPECT_TRUE(document().scene() == before);
  EXPECT_FALSE(document().canUndo());
  // No correction is farther from the truth than the box, and is seen to be.
  const auto psnr = [this](int view) { return numbers(view).section(", ", 1).section(' ', 0, 0).toDouble(); };
  EXPECT_GT(psnr(0), psnr(2));
  EXPECT_GT(differingShare(shown(0), shown(2)), 0.005);
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) window_->grab().save(QString(folder) + "/views.png");
  key(Qt::Key_Escape);
  EXPECT_FALSE(views().on());
  EXPECT_FALSE(views().views().isVisible());
  waitUntilIdle();
  EXPECT_LT(differingShare(picture, shownPicture(window_->viewport())), 0.001) << "the picture as it was";
}

TEST_F(ViewComparisonTest, BeforeStaysWhileTheSceneIsEdited) {
  key(Qt::Key_C, Qt::AltModifier);
  choose(1, "before");
  choose(2, "");
  choose(3, "");
  ASSERT_TRUE(made());
  ASSERT_TRUE(waitFor([this] { return numbers(1) == "No difference"; })) << numbers(1).toStdString();
  const QImage old = shown(1);
  window_->editor().commitProbe("Set technique", [](Probe& edited) { edited.technique = "infinite"; });
  ASSERT_TRUE(waitFor([this] { return numbers(1).startsWith("Error"); })) << numbers(1).toStdString();
  EXPECT_LT(differingShare(old, shown(1)), 0.002);
  EXPECT_GT(differingShare(old, shown(0)), 0.005);
  EXPECT_EQ(document().scene().probes.front().technique, "infinite") << "the document is not the view's";
  document().undo();
}

TEST_F(ViewComparisonTest, AnEditWhileAnotherViewIsMadeIsDrawn) {
  key(Qt::Key_C, Qt::AltModifier);
  ASSERT_TRUE(waitFor([this] { return !views().making() || window_->renderer().workPending(); }));
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x += 0.5; });
  key(Qt::Key_Escape);
  waitUntilIdle();
  const QImage after = shownPicture(window_->viewport());
  // As a window that never compared draws that scene.
  const Scene scene = document().scene();
  document().undo();
  waitUntilIdle();
  document().redo();
  waitUntilIdle();
  EXPECT_TRUE(document().scene() == scene);
  EXPECT_LT(differingShare(after, shownPicture(window_->viewport())), 0.001);
}

TEST_F(ViewComparisonTest, AnotherViewShowsThePictureUntilItRests) {
  key(Qt::Key_C, Qt::AltModifier);
  ASSERT_TRUE(made());
  key(Qt::Key_2, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([this] { return views().making(); }));
  EXPECT_FALSE(views().views().isVisible());
  ASSERT_TRUE(made());
  EXPECT_TRUE(views().views().isVisible());
  // One comparison at a time.
  key(Qt::Key_C);
  EXPECT_FALSE(views().on());
  EXPECT_TRUE(window_->tools().compare().active());
  key(Qt::Key_C, Qt::AltModifier);
  EXPECT_TRUE(views().on());
  EXPECT_FALSE(window_->tools().compare().active());
}

TEST_F(ViewComparisonTest, TheViewsAreMadeAnewWhereThePictureChanges) {
  key(Qt::Key_C, Qt::AltModifier);
  choose(1, "");
  choose(2, "technique:infinite");
  choose(3, "");
  ASSERT_TRUE(made());
  int others = 0, seen = 0;
  const auto connection =
      QObject::connect(&views(), &ViewComparison::ownSceneShown, [&others](bool own) { others += own ? 0 : 1; });
  const auto madeAnew = [&](const char* after) {
    SCOPED_TRACE(after);
    EXPECT_TRUE(QTest::qWaitFor([&] { return others > seen; }, 15000));
    EXPECT_TRUE(QTest::qWaitFor([this] { return !views().making(); }, 15000));
    EXPECT_TRUE(views().views().isVisible());
    seen = others;
  };
  const QImage lit = shown(0);
  key(Qt::Key_R, Qt::ControlModifier);
  madeAnew("reflections off");
  EXPECT_GT(differingShare(lit, shown(0)), 0.005);
  key(Qt::Key_R, Qt::ControlModifier);
  madeAnew("reflections on");
  EXPECT_LT(differingShare(lit, shown(0)), 0.001);
  key(Qt::Key_3, Qt::AltModifier);
  madeAnew("a surface view");
  EXPECT_GT(differingShare(lit, shown(0)), 0.005);
  key(Qt::Key_0, Qt::AltModifier);
  madeAnew("the picture");
  const QSize size = window_->size();
  window_->resize(size + QSize(120, 90));  // smaller than it is in these tests it cannot be
  madeAnew("a larger window");
  window_->resize(size);
  madeAnew("the window as it was");
  QObject::disconnect(connection);
}

TEST_F(ViewComparisonTest, BakingAndExplainingAreOfTheDocumentsScene) {
  // Both may bring a dock up that a test before has closed, and so make the picture narrower: once before it is taken.
  key(Qt::Key_F5);
  key(Qt::Key_E);
  key(Qt::Key_E);
  waitUntilIdle();
  const QImage picture = shownPicture(window_->viewport());
  // The views that the tests before chose may need no other scene.
  key(Qt::Key_C, Qt::AltModifier);
  choose(3, "live");
  key(Qt::Key_Escape);
  const auto away = [this] {
    int others = 0;
    const auto connection =
        QObject::connect(&views(), &ViewComparison::ownSceneShown, [&others](bool own) { others += own ? 0 : 1; });
    key(Qt::Key_C, Qt::AltModifier);
    const bool gone = QTest::qWaitFor([&others] { return others > 0; }, 15000);
    QObject::disconnect(connection);
    return gone;
  };
  ASSERT_TRUE(away());
  key(Qt::Key_F5);
  EXPECT_FALSE(views().on());
  waitUntilIdle();
  EXPECT_EQ(window_->renderer().bakeState("room"), BakeState::UpToDate);
  EXPECT_LT(differingShare(picture, shownPicture(window_->viewport())), 0.001);
  ASSERT_TRUE(away());
  key(Qt::Key_E);
  EXPECT_FALSE(views().on());
  key(Qt::Key_E);
  waitUntilIdle();
  EXPECT_LT(differingShare(picture, shownPicture(window_->viewport())), 0.001);
  EXPECT_FALSE(document().canUndo());
}

TEST(ViewScenes, EachChoiceIsAValidSceneOrNone) {
  const Scene now = smallBuilding().scene;
  int scenes = 0;
  for (const CompareViews::Choice& choice : viewChoices()) {
    const auto scene = viewScene(now, now, choice.id);
    if (!scene) continue;
    EXPECT_NO_THROW(validate(*scene)) << choice.id.toStdString();
    ++scenes;
  }
  EXPECT_GT(scenes, 10);
  EXPECT_FALSE(viewScene(now, now, "now"));
  const auto live = viewScene(now, now, "live");
  ASSERT_TRUE(live);
  for (const Probe& probe : live->probes) EXPECT_NE(probe.mode, ProbeMode::Baked);
}

}  // namespace
}  // namespace boxprobe
