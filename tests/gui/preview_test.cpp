// What a probe holds, looked at: the pictures are the maps', the sphere is lit by them, and nothing is read or drawn
// while nobody looks.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QSlider>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/panels/probe_preview.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/cube_view.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"
#include "tests/support/shown_light.h"

namespace boxprobe {
namespace {

using test::shownLight;

class PreviewTest : public WindowTest {
 protected:
  void TearDown() override {
    set("previewSphere", static_cast<int>(SphereKind::Off));
    set("previewWhat", 0);
    set("previewKind", static_cast<int>(CubePictureKind::Cross));
    named<QSlider>("previewLevel")->setValue(0);
    named<QDockWidget>("probes")->raise();
    window_->probeWidget().setVisible(true);
  }
  template <typename Widget>
  Widget* named(const char* name) const {
    auto* widget = window_->findChild<Widget*>(name);
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  ProbePreview* preview() const { return window_->findChild<ProbePreview*>(); }
  CubeFaces* view() const { return named<CubeFaces>("cubeView"); }
  /// By the keyboard, with the list open.
  void set(const char* name, int value) {
    auto* combo = named<QComboBox>(name);
    if (combo->currentData().toInt() == value) return;
    look();
    combo->setFocus();
    combo->showPopup();
    QTest::qWait(20);
    combo->view()->setCurrentIndex(combo->model()->index(combo->findData(value), 0));
    QTest::keyClick(combo->view(), Qt::Key_Return);
    settle();
  }
  void look() {
    named<QDockWidget>("cubemap")->raise();
    settle();
  }
  void settle() {
    waitUntilIdle();
    ASSERT_TRUE(QTest::qWaitFor([this] { return preview()->idle(); }, 20000));
    QCoreApplication::processEvents();
  }
  BakedMaps maps() const { return window_->renderer().readMaps("room").value(); }
  QImage drawn(int level, CubePictureKind kind) const {
    const ImageRgba8 p = drawCubePicture(maps().radiance, level, CubePicture(kind, view()->width()),
                                         static_cast<float>(window_->document().scene().exposure));
    return QImage(p.pixels.data(), p.width, p.height, QImage::Format_RGBA8888).copy();
  }
  /// For a look at it.
  void keep(const char* name) const {
    const QString folder = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
    if (folder.isEmpty()) return;
    QDir().mkpath(folder);
    QPixmap picture = window_->grab();
    QPainter(&picture).drawImage(window_->viewport().mapTo(window_, QPoint(0, 0)), shownPicture(window_->viewport()));
    picture.save(folder + "/preview_" + name + ".png");
  }
  /// How far, of 255, the pixels of a chrome sphere are from what its reflected rays find in `maps`; sorted.
  std::vector<int> chromeErrors(const BakedMaps& maps) const {
    const QImage image = shownPicture(window_->viewport());
    const auto exposure = static_cast<float>(window_->document().scene().exposure);
    const glm::dvec3 size = probe().box.size();
    const double radius = 0.1 * std::min({size.x, size.y, size.z});
    const QPointF middle = originPixel();
    std::vector<int> errors;
    for (int y = -30; y <= 30; y += 3) {
      for (int x = -30; x <= 30; x += 3) {
        const QPoint pixel(static_cast<int>(middle.x()) + x, static_cast<int>(middle.y()) + y);
        const Ray ray = window_->viewport().view().ray({pixel.x() + 0.5, pixel.y() + 0.5});
        const glm::dvec3 direction = glm::normalize(ray.direction), toEye = ray.origin - probe().origin;
        const double along = glm::dot(toEye, direction);
        // Facets show at the rim: its outer fifth is left out.
        const double d2 = glm::dot(toEye, toEye) - along * along;
        if (d2 > 0.64 * radius * radius) continue;
        const glm::dvec3 normal = (toEye + (-along - std::sqrt(radius * radius - d2)) * direction) / radius;
        const glm::vec4 light = maps.radiance.fetch(glm::vec3(glm::reflect(direction, normal)), 0.0f);
        const QColor seen = image.pixelColor(pixel);
        const auto byte = [exposure](float of) {
          return static_cast<int>(std::lround(255 * shownLight(of * exposure)));
        };
        errors.push_back(std::max({std::abs(seen.red() - byte(light.r)), std::abs(seen.green() - byte(light.g)),
                                   std::abs(seen.blue() - byte(light.b))}));
      }
    }
    std::sort(errors.begin(), errors.end());
    return errors;
  }
  glm::vec3 meanNear(const QPointF& at, int radius = 2) const {
    const QImage image = shownPicture(window_->viewport());
    glm::vec3 sum(0.0f);
    int count = 0;
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x, ++count) {
        const QColor c = image.pixelColor(static_cast<int>(at.x()) + x, static_cast<int>(at.y()) + y);
        sum += glm::vec3(c.red(), c.green(), c.blue());
      }
    }
    return sum / static_cast<float>(count);
  }
};

TEST_F(PreviewTest, ReadsNothingWhileHiddenAndOnceForEachMapOtherwise) {
  const int before = preview()->facesRead();
  window_->editor().commitProbe("Move", [](Probe& p) { p.origin.x += 0.1; });
  settle();
  EXPECT_EQ(preview()->facesRead(), before);
  look();
  EXPECT_EQ(preview()->facesRead() - before, 6);
  named<QSlider>("previewLevel")->setValue(2);
  settle();
  EXPECT_EQ(preview()->facesRead() - before, 12);
  set("previewKind", static_cast<int>(CubePictureKind::LatLong));
  window_->editor().commit("Set exposure", [](Scene& scene) { scene.exposure = 0.5; });
  settle();
  EXPECT_EQ(preview()->facesRead() - before, 12) << "another picture of the same texels";
  window_->editor().commitProbe("Move", [](Probe& p) { p.origin.x += 0.1; });
  settle();
  EXPECT_EQ(preview()->facesRead() - before, 18);
}

TEST_F(PreviewTest, ThePicturesAreTheMaps) {
  look();
  EXPECT_EQ(view()->image(), drawn(0, CubePictureKind::Cross));
  keep("cross");
  set("previewKind", static_cast<int>(CubePictureKind::LatLong));
  EXPECT_EQ(view()->image(), drawn(0, CubePictureKind::LatLong));
  keep("latlong");
  named<QSlider>("previewLevel")->setValue(1);
  settle();
  EXPECT_EQ(view()->image(), drawn(1, CubePictureKind::LatLong));
  set("previewKind", static_cast<int>(CubePictureKind::Cross));
  set("previewWhat", 1);
  keep("distance");
  EXPECT_FALSE(view()->image().isNull());
  EXPECT_FALSE(named<QSlider>("previewLevel")->isEnabled()) << "distances have one level";
  named<QDockWidget>("probes")->raise();
  keep("probes");
  auto* scroll = named<QDockWidget>("probes")->findChild<QScrollArea*>();
  scroll->ensureWidgetVisible(named<QWidget>("hides"));
  keep("capture");
}

TEST_F(PreviewTest, PointingReadsTheTexel) {
  look();
  const glm::vec3 kTexel(0.28125f, -0.21875f, 1.0f);  // the middle of one of 32 x 32
  const CubePicture picture(CubePictureKind::Cross, view()->image().width());
  const glm::dvec2 at = picture.position(kTexel);
  const QPoint inWindow = view()->mapTo(window_, QPoint(static_cast<int>(at.x), static_cast<int>(at.y)));
  QTest::mouseMove(window_->windowHandle(), inWindow);
  QCoreApplication::processEvents();
  const QString text = named<QLabel>("cubeReadout")->text();
  const CubePoint point = cubePoint(kTexel);
  const int column = static_cast<int>((0.5f * point.s + 0.5f) * 32.0f),
            row = static_cast<int>((0.5f * point.t + 0.5f) * 32.0f);
  EXPECT_TRUE(text.startsWith(QString("Face +Z, column %1, row %2").arg(column).arg(row))) << text.toStdString();
  const glm::vec4 texel = maps().radiance.texel(0, 4, column, row);
  EXPECT_TRUE(text.contains(QString::number(static_cast<double>(texel.g), 'g', 4))) << text.toStdString();
}

TEST_F(PreviewTest, TheSphereShowsTheProbesOwnMapsAndIsGoneWhenHidden) {
  look();
  const BakedMaps before = maps();
  // Nothing stands between the eye and the sphere, and no handle is drawn over it.
  window_->probeWidget().setVisible(false);
  settle();
  const QImage without = shownPicture(window_->viewport());
  const std::uint64_t faces = counters().facesCaptured;

  set("previewSphere", static_cast<int>(SphereKind::Chrome));
  keep("chrome");
  const std::vector<int> off = chromeErrors(before);
  ASSERT_GT(off.size(), 50u);
  // Half of the sphere within rounding; the rest within what a shift of half a pixel makes on small detail.
  EXPECT_LE(off[off.size() / 2], 4);
  EXPECT_LE(off[off.size() * 9 / 10], 24);
  const glm::vec3 chrome = meanNear(originPixel());
  EXPECT_GT(differingShare(without, shownPicture(window_->viewport())), 1e-3);

  set("previewSphere", static_cast<int>(SphereKind::Diffuse));
  keep("diffuse");
  EXPECT_GT(glm::length(meanNear(originPixel()) - chrome), 4.0f);
  named<QSlider>("previewLevel")->setValue(2);
  set("previewSphere", static_cast<int>(SphereKind::Rough));
  keep("rough");
  EXPECT_EQ(window_->renderer().previewSphere().kind, SphereKind::Rough);

  // Captured with the sphere on show: it is not in the maps.
  key(Qt::Key_F5);
  settle();
  EXPECT_EQ(counters().facesCaptured - faces, 6u);
  const BakedMaps after = maps();
  for (int i = 0; i < 32 * 32; i += 7) {
    EXPECT_EQ(after.radiance.texel(0, 2, i % 32, i / 32), before.radiance.texel(0, 2, i % 32, i / 32));
  }
  set("previewSphere", static_cast<int>(SphereKind::Off));
  EXPECT_EQ(differingShare(without, shownPicture(window_->viewport()), 0), 0.0);
}

}  // namespace
}  // namespace boxprobe
