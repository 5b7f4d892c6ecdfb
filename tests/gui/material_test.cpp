// Roughness and exposure: the sliders show live and commit when let go.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTest>

#include "app/gui/view/viewport.h"
#include "app/gui/widgets/value_field.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class MaterialTest : public WindowTest {
 protected:
  QRect handleOf(QSlider* slider) const {
    QStyleOptionSlider option;
    option.initFrom(slider);
    option.orientation = Qt::Horizontal;
    option.minimum = slider->minimum();
    option.maximum = slider->maximum();
    option.sliderPosition = slider->sliderPosition();
    option.sliderValue = slider->value();
    return slider->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider);
  }
};

TEST_F(MaterialTest, TheRoughnessSliderIsLiveAndOneStep) {
  auto* materials = window_->findChild<QComboBox*>("material");
  auto* slider = window_->findChild<QSlider*>("roughness");
  ASSERT_GT(materials->count(), 1) << "the materials of the model must be there by name";
  ASSERT_GE(materials->findText("mirror"), 0);
  materials->setCurrentIndex(materials->findText("mirror"));
  emit materials->activated(materials->currentIndex());
  const QImage smooth = shownPicture(window_->viewport());
  const QPoint from = handleOf(slider).center();
  QTest::mousePress(slider, Qt::LeftButton, {}, from);
  const QPoint at = from + QPoint(slider->width() / 2, 0);
  QMouseEvent moved(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(slider, &moved);
  const auto changed = [&] { return differingShare(smooth, shownPicture(window_->viewport())) > 0.01; };
  EXPECT_TRUE(QTest::qWaitFor(changed, 60000)) << "the picture must follow the slider";
  EXPECT_TRUE(document().previewing());
  const auto& materialsNow = document().scene().materials;
  ASSERT_TRUE(materialsNow.count("mirror"));
  const float roughness = materialsNow.at("mirror").roughness.value_or(0.0f);
  EXPECT_NEAR(roughness, 0.5f, 0.15f);
  QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(slider->width() / 2, 0));
  EXPECT_FALSE(document().previewing());
  EXPECT_EQ(document().undoLabel(), "Set roughness of mirror");
  document().undo();
  EXPECT_FALSE(document().canUndo());
  EXPECT_EQ(document().scene().materials.count("mirror"), 0u);
}

// The sphere becomes glass and is drawn again at once; each value is one step to undo, and all go back together.
TEST_F(MaterialTest, GlassIsSetLiveAndUndone) {
  auto* materials = window_->findChild<QComboBox*>("material");
  ASSERT_GE(materials->findText("mirror"), 0);
  materials->setCurrentIndex(materials->findText("mirror"));
  emit materials->activated(materials->currentIndex());
  auto* transmission = window_->findChild<ValueField*>("transmission");
  auto* ior = window_->findChild<ValueField*>("ior");
  auto* form = window_->findChild<QComboBox*>("glassForm");
  auto* thin = window_->findChild<QCheckBox*>("thin");
  ASSERT_TRUE(transmission && ior && form && thin);
  EXPECT_FALSE(form->isEnabled()) << "nothing is transmitted yet";
  const auto now = [&] { return document().scene().materials.at("mirror"); };
  emit transmission->committed(1.0);
  EXPECT_EQ(now().transmission, 1.0f);
  EXPECT_TRUE(form->isEnabled());
  EXPECT_EQ(document().undoLabel(), "Set transmission of mirror");
  waitUntilIdle();
  EXPECT_GE(counters().glassDraws, 1u) << "the picture follows";
  emit ior->previewed(2.4);
  EXPECT_TRUE(document().previewing());
  EXPECT_EQ(now().ior, 2.4f);
  emit ior->committed(2.4);
  EXPECT_FALSE(document().previewing());
  emit form->activated(2);
  EXPECT_EQ(now().glass, GlassForm::TwoPass);
  thin->click();
  EXPECT_EQ(now().thin, false) << "the model's, which has no thickness, is thin";
  for (const char* label : {"Set thinness of mirror", "Set form of mirror", "Set index of mirror"}) {
    EXPECT_EQ(document().undoLabel(), label);
    document().undo();
  }
  document().undo();
  EXPECT_FALSE(document().canUndo());
  waitUntilIdle();
  EXPECT_EQ(counters().glassDraws, 0u);
}

TEST_F(MaterialTest, ExposureBrightensThePicture) {
  const auto mean = [this] {
    const QImage image = shownPicture(window_->viewport());
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) sum += qGreen(image.pixel(x, y));
    }
    return sum / (static_cast<double>(image.width()) * image.height());
  };
  const double before = mean();
  const std::uint64_t faces = counters().facesCaptured;
  window_->editor().commit("Set exposure", [](Scene& scene) { scene.exposure = 0.25; });
  waitUntilIdle();
  EXPECT_LT(mean(), 0.75 * before);
  EXPECT_EQ(counters().facesCaptured, faces);
}

}  // namespace
}  // namespace boxprobe
