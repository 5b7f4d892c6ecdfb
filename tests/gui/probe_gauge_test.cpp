// The live error: numbers that follow a drag, the mark of the worst face that a click puts right, the worst spot.
#include "app/gui/edit/probe_gauge.h"

#include <gtest/gtest.h>
#include <time.h>

#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <glm/geometric.hpp>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/panels/fit_panel.h"
#include "app/gui/view/viewport.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

constexpr BoxFace kPlusX{0, true}, kMinusX{0, false};
constexpr int kPlusXNumber = 1;  // of fitted faces: -x +x -y +y -z +z

class ProbeGaugeTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    // As at a first start: the handles of four faces are in view.
    window_->resizeDocks({window_->findChild<QDockWidget*>("outliner")}, {230}, Qt::Horizontal);
    waitUntilIdle();
    right_ = loadSceneFile(BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json").probes.front();
    window_->editor().commitProbe("Set box", [this](Probe& probe) {
      probe.origin = right_.origin;
      probe.box = right_.box;
    });
    waitUntilIdle();
    ASSERT_TRUE(measured());
  }
  ProbeGauge& gauge() { return window_->findChild<FitPanel*>()->gauge(); }
  const Probe& shown() { return window_->editor().scene().probes.front(); }
  bool measured() {
    return QTest::qWaitFor([this] { return gauge().current() && !gauge().running(); }, 60000);
  }
  double mean() { return gauge().gauge()->errors.meanDegrees; }
  void moveFaceBy(double metres) {
    window_->editor().commitProbe("Set box", [metres](Probe& probe) { probe.box.max.x += metres; });
    waitUntilIdle();
    ASSERT_TRUE(measured());
  }
  template <typename Widget>
  Widget* find(const QString& name) {
    auto* found = window_->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name.toStdString();
    return found;
  }
  void keep(const char* name) {
    const QString folder = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
    if (!folder.isEmpty()) window_->grab().save(folder + "/" + name + ".png");
  }

  Probe right_;
};

TEST_F(ProbeGaugeTest, FollowsADragWithoutRaysOfItsOwn) {
  const double before = mean();
  const ProbeGauge::Counts counts = gauge().counts();
  // The one of +x is at the right of the picture.
  const QPointF from = facePixel(kMinusX), to = facePixelAfter(kMinusX, -1.2);
  press(from);
  move(from + 0.5 * (to - from));
  move(to);
  ASSERT_TRUE(document().previewing());
  // The number comes while the button is held.
  EXPECT_TRUE(QTest::qWaitFor([&] { return gauge().current() && mean() > before + 0.1; }, 60000)) << mean();
  EXPECT_TRUE(document().previewing());
  EXPECT_EQ(find<QLabel>("gaugeMean")->text().contains(QString::number(mean(), 'f', mean() < 10.0 ? 2 : 1)), true);
  EXPECT_EQ(gauge().gauge()->worst, 0) << "-x";
  EXPECT_EQ(gauge().counts().rays, counts.rays) << "the origin stayed: the same rays do";
  EXPECT_EQ(gauge().counts().structures, counts.structures);
  EXPECT_GT(gauge().counts().boxes, counts.boxes);
  keep("gauge-drag");
  key(Qt::Key_Escape);
  release(to);
  EXPECT_TRUE(shown().box == right_.box);
  ASSERT_TRUE(measured());
  EXPECT_NEAR(mean(), before, 1e-9);
}

TEST_F(ProbeGaugeTest, MeasuresElsewhereAndTheNewestOnly) {
  const ProbeGauge::Counts counts = gauge().counts();
  const EditToken token{&counts};
  constexpr int kMoves = 40;
  for (int i = 1; i <= kMoves; ++i) {
    window_->editor().previewProbe(token, "Set box",
                                   [&](Probe& probe) { probe.box.max.x = right_.box.max.x + 0.02 * i; });
    EXPECT_FALSE(gauge().current());
    gauge().update();
    EXPECT_FALSE(gauge().current()) << "measured in the window's thread";
  }
  ASSERT_TRUE(measured());
  EXPECT_LE(gauge().counts().boxes, counts.boxes + 2)
      << "what was passed over while the window was busy is not measured";
  EXPECT_EQ(gauge().gauge()->worst, kPlusXNumber);
  window_->editor().cancel();
}

/// Counts how often a widget was greyed.
class Greyed : public QObject {
 public:
  explicit Greyed(QWidget* widget) : widget_(widget) { widget->installEventFilter(this); }
  int times() const { return times_; }

 protected:
  bool eventFilter(QObject* of, QEvent* event) override {
    if (of == widget_ && event->type() == QEvent::EnabledChange && !widget_->isEnabled()) ++times_;
    return false;
  }

 private:
  QWidget* widget_;
  int times_ = 0;
};

TEST_F(ProbeGaugeTest, NumbersOlderThanTheBoxAreGrey) {
  auto* shownMean = find<QLabel>("gaugeMean");
  const Greyed greyed(shownMean);
  ASSERT_TRUE(shownMean->isEnabled());
  window_->editor().commitProbe("Set box", [](Probe& probe) { probe.box.max.x += 0.7; });
  EXPECT_TRUE(shownMean->isEnabled()) << "the next number is awaited first";
  QTest::qSleep(600);  // the window is busy: that number is late
  ASSERT_TRUE(measured());
  EXPECT_EQ(greyed.times(), 1);
  EXPECT_TRUE(shownMean->isEnabled());
}

TEST_F(ProbeGaugeTest, AClickOnTheMarkInThePanelSnapsTheFace) {
  moveFaceBy(1.5);
  const double wrong = mean();
  ASSERT_EQ(gauge().gauge()->worst, kPlusXNumber);
  auto* mark = find<QToolButton>("gaugeSnap1");
  ASSERT_TRUE(mark->isVisible());
  EXPECT_TRUE(mark->property("worst").toBool());
  keep("gauge-panel");
  QTest::mouseClick(mark, Qt::LeftButton);
  waitUntilIdle();
  ASSERT_TRUE(measured());
  EXPECT_NEAR(shown().box.max.x, right_.box.max.x, 0.1);
  EXPECT_LT(mean(), wrong - 0.1);
  EXPECT_FALSE(mark->property("worst").toBool());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NEAR(shown().box.max.x, right_.box.max.x + 1.5, 1e-9) << "one step";
  EXPECT_EQ(shown().box.min, right_.box.min);
}

TEST_F(ProbeGaugeTest, AClickOnTheMarkInThePictureSnapsTheFaceAndOthersLetTheMouseThrough) {
  moveFaceBy(-1.2);
  ASSERT_EQ(gauge().gauge()->worst, kPlusXNumber);
  auto* tag = find<QToolButton>("faceTag1");
  ASSERT_TRUE(QTest::qWaitFor([tag] { return tag->isVisible(); }, 60000));
  const QRect beside = tag->geometry().adjusted(-24, -24, 24, 24);
  EXPECT_TRUE(beside.contains(facePixel(kPlusX).toPoint())) << "beside its handle";
  EXPECT_FALSE(tag->geometry().adjusted(-4, -4, 4, 4).contains(facePixel(kPlusX).toPoint())) << "and not over it";
  EXPECT_FALSE(tag->testAttribute(Qt::WA_TransparentForMouseEvents));
  int others = 0;
  for (int face = 0; face < kFaces; ++face) {
    if (face == kPlusXNumber) continue;
    auto* other = find<QToolButton>(QString("faceTag%1").arg(face));
    if (!other->isVisible()) continue;
    ++others;
    EXPECT_TRUE(other->testAttribute(Qt::WA_TransparentForMouseEvents)) << face;
  }
  EXPECT_GT(others, 2);
  keep("gauge-tags");
  dragOver(tag, QPointF(4.0, 4.0), QPointF(4.0, 4.0), 1);  // a click
  waitUntilIdle();
  ASSERT_TRUE(measured());
  EXPECT_NEAR(shown().box.max.x, right_.box.max.x, 0.1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NEAR(shown().box.max.x, right_.box.max.x - 1.2, 1e-9);
}

TEST_F(ProbeGaugeTest, TagsGoWithTheHandles) {
  auto* tag = find<QToolButton>("faceTag0");
  const auto visible = [&] { return QTest::qWaitFor([tag] { return tag->isVisible(); }, 60000); };
  const auto hidden = [&] { return QTest::qWaitFor([tag] { return !tag->isVisible(); }, 60000); };
  EXPECT_TRUE(visible());
  key(Qt::Key_B, Qt::ControlModifier);
  EXPECT_TRUE(hidden());
  key(Qt::Key_B, Qt::ControlModifier);
  EXPECT_TRUE(visible());
  key(Qt::Key_2);  // handles of the influence box
  EXPECT_TRUE(hidden());
  key(Qt::Key_1);
  EXPECT_TRUE(visible());
  QTest::mouseClick(find<QCheckBox>("liveError"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_TRUE(hidden());
  EXPECT_FALSE(gauge().gauge());
  QTest::mouseClick(find<QCheckBox>("liveError"), Qt::LeftButton, {}, QPoint(8, 8));
  EXPECT_TRUE(visible());
}

TEST_F(ProbeGaugeTest, TheWorstSpotIsLookedAtAndLeft) {
  moveFaceBy(2.0);
  ASSERT_TRUE(gauge().gauge()->spot);
  const WorstSpot spot = *gauge().gauge()->spot;
  const Camera before = window_->renderer().currentCamera();
  auto* back = find<QPushButton>("worstSpotBack");
  EXPECT_FALSE(back->isEnabled());
  QTest::mouseClick(find<QPushButton>("worstSpot"), Qt::LeftButton);
  waitUntilIdle();
  const QPointF middle(0.5 * window_->viewport().width(), 0.5 * window_->viewport().height());
  EXPECT_LT(QPointF(pixelOf(spot.positionWorld) - middle).manhattanLength(), 3.0) << "in the middle of the picture";
  const Camera there = window_->renderer().currentCamera();
  const glm::dvec3 seen = glm::normalize(there.position - spot.positionWorld);
  EXPECT_NEAR(glm::dot(seen, glm::normalize(spot.eyeWorld - spot.positionWorld)), 1.0, 1e-6)
      << "from where the reflection is wrong";
  EXPECT_TRUE(find<QLabel>("spotTag")->isVisible());
  EXPECT_FALSE(document().previewing());
  keep("gauge-spot");
  EXPECT_TRUE(back->isEnabled());
  QTest::mouseClick(back, Qt::LeftButton);
  waitUntilIdle();
  EXPECT_LT(glm::length(window_->renderer().currentCamera().position - before.position), 1e-9);
  EXPECT_FALSE(find<QLabel>("spotTag")->isVisible());
  EXPECT_FALSE(back->isEnabled());
}

TEST_F(ProbeGaugeTest, AnotherSceneHasNoViewToComeBackTo) {
  moveFaceBy(2.0);
  QTest::mouseClick(find<QPushButton>("worstSpot"), Qt::LeftButton);
  waitUntilIdle();
  EXPECT_TRUE(find<QPushButton>("worstSpotBack")->isEnabled());
  window_->showScene(scene());
  waitUntilIdle();
  EXPECT_FALSE(find<QPushButton>("worstSpotBack")->isEnabled());
  EXPECT_FALSE(find<QLabel>("spotTag")->isVisible());
}

TEST_F(ProbeGaugeTest, AnotherOriginIsMeasuredAnew) {
  const ProbeGauge::Counts counts = gauge().counts();
  window_->editor().commitProbe("Move", [](Probe& probe) { probe.origin.y += 0.5; });
  ASSERT_TRUE(measured());
  EXPECT_EQ(gauge().counts().rays, counts.rays + 1);
  EXPECT_EQ(gauge().counts().structures, counts.structures);
  window_->editor().commitProbe("Name", [](Probe& probe) { probe.intensity = 0.5; });
  ASSERT_TRUE(measured());
  EXPECT_EQ(gauge().counts().rays, counts.rays + 1) << "nothing that rays meet";
}

}  // namespace
}  // namespace boxprobe
