// The schematic as it is painted: every part visible in its colour, at any resolution, and whatever is undefined.
#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "app/gui/explain/schematic_painter.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

constexpr int kWidth = 520, kHeight = 260;

QImage painted(const Schematic& drawing, int scale = 1) {
  QImage image(scale * kWidth, scale * kHeight, QImage::Format_RGB32);
  image.setDevicePixelRatio(scale);
  image.fill(Qt::black);
  QPainter painter(&image);
  paintSchematic(painter, QRectF(0, 0, kWidth, kHeight), drawing);
  return image;
}

int pixelsOf(const QImage& image, const QColor& color) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor at = image.pixelColor(x, y);
      const int off = std::max(
          {std::abs(at.red() - color.red()), std::abs(at.green() - color.green()), std::abs(at.blue() - color.blue())});
      count += off < 24 ? 1 : 0;
    }
  }
  return count;
}

const QColor kEye(115, 199, 255), kNormal(51, 217, 158), kReflected(255, 166, 26), kLookup(230, 140, 204),
    kDecides(255, 104, 84);

TEST(SchematicPainter, ShowsEveryPartAndGetsFinerWithTheScreen) {
  const auto drawing = schematic(ExplainedRoom().explain());
  ASSERT_TRUE(drawing);
  const QImage once = painted(*drawing), twice = painted(*drawing, 2);
  for (const QColor& color : {kEye, kNormal, kReflected, kLookup, kDecides}) {
    const int small = pixelsOf(once, color);
    EXPECT_GT(small, 40) << color.name().toStdString();
    EXPECT_GT(pixelsOf(twice, color), 2.5 * small) << color.name().toStdString() << ": lines and letters, not pixels";
  }
}

TEST(SchematicPainter, AnEyeThatIsOutsideIsNamedWhereItsRayComesIn) {
  const QColor label(150, 156, 165);
  ExplainedRoom inside, outside;
  outside.surface.eyeWorld =
      outside.surface.positionWorld + 40.0 * (inside.surface.eyeWorld - inside.surface.positionWorld);
  const int without = pixelsOf(painted(*schematic(inside.explain())), label);
  EXPECT_GT(pixelsOf(painted(*schematic(outside.explain())), label), without + 60);
}

TEST(SchematicPainter, WithoutABoxNothingDecides) {
  ExplainedRoom room;
  room.probe.technique = "infinite";
  const QImage image = painted(*schematic(room.explain()));
  EXPECT_GT(pixelsOf(image, kReflected), 20);
  EXPECT_GT(pixelsOf(image, kLookup), 20);
}

TEST(SchematicPainter, AnInsetIsOneViewWithoutAxesUnderItsWords) {
  // Axes are painted in the lower left corner: an inset as high as the view has nothing there but its own lines.
  constexpr int kInsetWidth = 310, kInsetHeight = 230;
  const auto view = insetView(ExplainedRoom().explain(), false);
  ASSERT_TRUE(view);
  const auto inset = [&](const SchematicView& shown) {
    QImage image(kInsetWidth, kInsetHeight, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    paintInset(painter, QRectF(0, 0, kInsetWidth, kInsetHeight), shown, "from above");
    return image;
  };
  SchematicView bare = *view;
  bare.lines.clear();
  bare.points.clear();
  bare.planes.clear();
  bare.boxLow.reset();
  bare.boxHigh.reset();
  // Without any part all that is left is the paper and the words: every row below them is of one colour.
  const QImage empty = inset(bare);
  const QColor paper = empty.pixelColor(kInsetWidth / 2, kInsetHeight / 2);
  int words = 0;
  for (int y = 8; y < kInsetHeight - 8; ++y) {
    for (int x = 8; x < kInsetWidth - 8; ++x) {
      if (empty.pixelColor(x, y) == paper) continue;
      ++words;
      ASSERT_LT(y, kInsetHeight / 6) << "column " << x << ": neither axes nor their names";
    }
  }
  EXPECT_GT(words, 60);
  const QImage whole = inset(*view);
  EXPECT_GT(pixelsOf(whole, kReflected), 40);
  EXPECT_GT(pixelsOf(whole, kDecides), 40);
}

TEST(SchematicPainter, DrawsWhatIsOddToo) {
  ExplainedRoom outside;
  outside.probe.origin = {0.0, 40.0, 0.0};
  ExplainedRoom flat;
  flat.probe.box.max.y = flat.probe.box.min.y;
  ExplainedRoom endOn;
  endOn.surface.eyeWorld = endOn.surface.positionWorld + glm::dvec3(0.0, 2.0, 0.0);
  endOn.surface.viewWorld = {0.0f, 1.0f, 0.0f};
  ExplainedRoom farAway;
  farAway.surface.eyeWorld = {1e5, 1e5, 1e5};
  farAway.surface.viewWorld = glm::normalize(glm::vec3(1.0f));
  for (const ExplainedRoom* room : {&outside, &flat, &endOn, &farAway}) {
    const auto drawing = schematic(room->explain());
    ASSERT_TRUE(drawing);
    EXPECT_GT(pixelsOf(painted(*drawing), kReflected), 20);
  }
}

}  // namespace
}  // namespace boxprobe
