// What a comparison says of the picture's light against the traced one: of a scene whose traced picture is known, an
// even sky, so that every number can be calculated.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QTest>
#include <cmath>

#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/picture_compare.h"
#include "app/gui/view/picture_difference.h"
#include "app/gui/view/view_comparison.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class TracedLightTest : public WindowTest {
 protected:
  static constexpr int kWidth = 48, kHeight = 32;
  static glm::dvec3 skyColor() { return {0.62, 0.35, 0.17}; }
  TracedLightTest() {
    Scene scene;
    scene.sky = SkyColor{glm::vec3(skyColor())};
    document_.open(scene, "");
    picture_.resize(kWidth, kHeight);
  }
  static QImage shown() {
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    image.fill(QColor(120, 90, 60));
    return image;
  }
  /// The sky times a factor that is another one in the upper quarter.
  static ImageRgbaF light(const QSize& size, double upper, double lower) {
    ImageRgbaF image{size.width(), size.height(), {}};
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        for (int c = 0; c < 3; ++c) {
          image.pixels.push_back(static_cast<float>((4 * y < image.height ? upper : lower) * skyColor()[c]));
        }
        image.pixels.push_back(1.0f);
      }
    }
    return image;
  }
  static Camera camera() {
    Camera camera;
    camera.target = {0.3, 0.2, -1.0};
    return camera;
  }

  Document document_;
  QWidget picture_;
};

TEST_F(TracedLightTest, TheDifferenceIsOfLinearLight) {
  ReferencePicture truth;
  truth.color = light({kWidth, kHeight}, 1.0, 1.0);
  truth.standardError = light({kWidth, kHeight}, 0.1, 0.1);
  const auto off = lightDifference(light({kWidth, kHeight}, 2.0, 0.8), truth);
  ASSERT_TRUE(off.has_value());
  EXPECT_NEAR(off->light, 0.25 * 2.0 + 0.75 * 0.8, 1e-6);
  EXPECT_NEAR(off->relativeRmse, std::sqrt(0.25 * 1.0 + 0.75 * 0.04 - 0.01), 1e-6);
  EXPECT_NEAR(off->noise, 0.1, 1e-6);
  EXPECT_EQ(lightText(*off), "light 1.10, RMSE 0.52, noise 0.10");
  EXPECT_EQ(lightText({0.963, 0.142, 0.003}), "light 0.96, RMSE 0.14");
  EXPECT_FALSE(lightDifference(light({kWidth, kHeight - 1}, 2.0, 0.8), truth).has_value());
  EXPECT_FALSE(lightDifference({}, truth).has_value());
}

TEST_F(TracedLightTest, ThePictureBesideTheTracedOneSaysIt) {
  CompareWipe wipe(&picture_);
  PictureCompare compare(document_, wipe,
                         {[] { return true; }, [] { return shown(); },
                          [](const QSize& size) { return light(size, 1.7, 0.7); }, [] { return camera(); },
                          [] { return std::vector<std::shared_ptr<const Model>>(); }, [] { return ProbesDiffuse(); }});
  const auto* numbers = picture_.findChild<QLabel*>("compareNumbers");
  compare.traceReference();
  // 0.25 x 1.7 + 0.75 x 0.7; the root of 0.25 x 0.49 + 0.75 x 0.09.
  ASSERT_TRUE(waitFor([&] { return numbers->text().endsWith(". Against the traced: light 0.95, RMSE 0.44"); }))
      << numbers->text().toStdString();
  EXPECT_TRUE(numbers->text().startsWith("Difference: PSNR ")) << numbers->text().toStdString();
  compare.setDifference(true);
  ASSERT_TRUE(waitFor([&] { return numbers->text().contains("mean"); })) << numbers->text().toStdString();
  EXPECT_TRUE(numbers->text().endsWith(". Against the traced: light 0.95, RMSE 0.44")) << numbers->text().toStdString();
  // Of a picture that was held nothing of the kind is known.
  compare.stop();
  compare.hold();
  ASSERT_TRUE(waitFor([&] { return numbers->text() == "No difference"; })) << numbers->text().toStdString();
}

TEST_F(TracedLightTest, EachOfFourViewsSaysIt) {
  bool drawnOtherwise = false;
  ViewComparison comparison(
      document_, &picture_,
      {[] { return true; }, [] { return shown(); },
       [&](const QSize& size) { return drawnOtherwise ? light(size, 1.3, 1.3) : light(size, 1.7, 0.7); },
       [] { return camera(); }, [] { return std::vector<std::shared_ptr<const Model>>(); },
       [&](const Scene&, const Changes&) { drawnOtherwise = !drawnOtherwise; }});
  CompareViews& views = comparison.views();
  views.choose(2, "before");
  views.choose(3, "");
  comparison.setOn(true);
  ASSERT_TRUE(waitFor([&] { return views.numbers(0).endsWith("\nlight 0.95, RMSE 0.44"); }))
      << views.numbers(0).toStdString();
  EXPECT_TRUE(views.numbers(0).startsWith("Error ")) << views.numbers(0).toStdString();
  EXPECT_TRUE(views.numbers(2).endsWith("\nlight 1.30, RMSE 0.30")) << views.numbers(2).toStdString();
  comparison.setOn(false);
}

}  // namespace
}  // namespace boxprobe
