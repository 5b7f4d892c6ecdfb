// Exposure beside the picture: the slider of the tool bar, keys, and what the picture itself asks for.
#include <gtest/gtest.h>

#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "app/gui/edit/exposure_control.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/value_field.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class ExposureTest : public WindowTest {
 protected:
  double exposure() { return document().scene().exposure; }
  double brightness() {
    const QImage picture = shownPicture(window_->viewport());
    double sum = 0.0;
    for (int y = 0; y < picture.height(); y += 4) {
      for (int x = 0; x < picture.width(); x += 4) sum += qGray(picture.pixel(x, y));
    }
    return 16.0 * sum / (picture.width() * picture.height());
  }
  ExposureControl* bar() { return window_->findChild<ExposureControl*>("exposureInBar"); }
};

TEST_F(ExposureTest, TheSliderInTheToolBarIsLiveAndOneStep) {
  ASSERT_NE(bar(), nullptr);
  auto* slider = bar()->findChild<QSlider*>();
  const double before = exposure(), bright = brightness();
  const int y = slider->height() / 2;
  const auto at = [&](int value) {
    return QPointF(
        QStyle::sliderPositionFromValue(slider->minimum(), slider->maximum(), value, slider->width() - 12) + 6, y);
  };
  // The picture is drawn while the button is still down.
  bool live = false;
  const auto watch = QObject::connect(slider, &QSlider::sliderMoved, [&] { live |= document().previewing(); });
  dragOver(slider, at(slider->value()), at(-30));
  QObject::disconnect(watch);
  EXPECT_TRUE(live);
  EXPECT_LT(exposure(), 0.5 * before);
  waitUntilIdle();
  EXPECT_LT(brightness(), 0.8 * bright);
  EXPECT_EQ(document().stepLabels().size(), 1u);
  EXPECT_EQ(document().undoLabel(), "Set exposure");
  window_->editor().undo();
  EXPECT_EQ(exposure(), before);
  EXPECT_NEAR(bar()->findChild<ValueField*>()->value(), before, 1e-3);
}

TEST_F(ExposureTest, TheSliderSpansSixStopsEitherWay) {
  auto* slider = bar()->findChild<QSlider*>();
  slider->setValue(1000);
  EXPECT_NEAR(exposure(), 64.0, 1e-6);
  slider->setValue(-1000);
  EXPECT_NEAR(exposure(), 1.0 / 64.0, 1e-6);
}

TEST_F(ExposureTest, KeysChangeItByThirdsOfAStopAsOneStep) {
  window_->viewport().setFocus();
  const double before = exposure();
  for (int i = 0; i < 3; ++i) key(Qt::Key_BracketRight);
  EXPECT_NEAR(exposure(), 2.0 * before, 0.01 * before);
  for (int i = 0; i < 6; ++i) key(Qt::Key_BracketLeft);
  EXPECT_NEAR(exposure(), 0.5 * before, 0.01 * before);
  EXPECT_TRUE(waitFor([this] { return !document().previewing(); }));
  window_->editor().undo();
  EXPECT_EQ(exposure(), before);
}

TEST_F(ExposureTest, ThePictureAsksForItsOwn) {
  window_->editor().commit("Set exposure", [](Scene& scene) { scene.exposure = 50.0; });
  waitUntilIdle();
  QTest::mouseClick(window_->findChild<QToolButton*>("exposeAutomatically"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([this] { return exposure() != 50.0; }));
  EXPECT_LT(exposure(), 10.0);
  EXPECT_EQ(document().undoLabel(), "Automatic exposure");
  window_->editor().undo();
  EXPECT_EQ(exposure(), 50.0);
  waitUntilIdle();
}

}  // namespace
}  // namespace boxprobe
