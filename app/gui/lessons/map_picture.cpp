// See map_picture.h.
#include "app/gui/lessons/map_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/lessons/other_maps.h"
#include "filters/core/base/errors.h"
#include "filters/core/picture/baked_probe.h"
#include "filters/core/picture/cube_picture.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

const QColor kMapInk("#1d2126"), kSampled("#a2267a"), kRightPlace("#0b5cad");
constexpr int kMapLetters = 17;  // pixels, as in curves
constexpr int kMapGap = 10, kHeading = 46, kRowName = 24;
constexpr int kLookupColumns = 9, kLookupRows = 5;  // pixels whose lookups are drawn
constexpr double kPaleness = 0.45;

QImage mapImage(const ImageRgba8& picture) {
  return QImage(picture.pixels.data(), picture.width, picture.height, QImage::Format_RGBA8888)
      .convertToFormat(QImage::Format_RGB888);
}

/// One face out of the cross, as CubePicture lays it out.
QImage faceImage(const CubeMap& cube, int level, int face, int size, float exposure) {
  constexpr int kCells[6][2] = {{0, 1}, {2, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
  const CubePicture cross(CubePictureKind::Cross, 4 * size);
  return mapImage(drawCubePicture(cube, level, cross, exposure))
      .copy(kCells[face][0] * size, kCells[face][1] * size, size, size);
}

QFont mapLetters() {
  QFont font("DejaVu Sans");
  font.setPixelSize(kMapLetters);
  return font;
}

QImage levelsPicture(const LessonMap& map, const CubeMap& cube, float exposure, int width, int height) {
  QImage picture(width, height, QImage::Format_RGB888);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  painter.setFont(mapLetters());
  painter.setPen(kMapInk);
  const auto columns = static_cast<int>(map.levels.size());
  const int size =
      std::min((width - kRowName - kMapGap * (columns + 1)) / columns, (height - kHeading - 3 * kMapGap) / 2);
  const int inset = kRowName + (width - kRowName - columns * size - (columns - 1) * kMapGap) / 2;
  const char* const rows[] = {"over the lobe", "plain means"};
  for (int row = 0; row < 2; ++row) {
    painter.save();
    painter.translate(inset - kRowName, kHeading + row * (size + kMapGap) + size);
    painter.rotate(-90.0);
    painter.drawText(QRect(0, 0, size, kRowName), Qt::AlignCenter, rows[row]);
    painter.restore();
  }
  const CubeMap means = withPlainMeans(cube);
  for (int i = 0; i < columns; ++i) {
    const int level = map.levels[static_cast<std::size_t>(i)], x = inset + i * (size + kMapGap);
    if (level >= cube.levels()) {
      throw WorkError("the cubemap has levels 0 to " + std::to_string(cube.levels() - 1) + ", not " +
                      std::to_string(level));
    }
    painter.drawText(QRect(x, 0, size, kHeading), Qt::AlignCenter,
                     QString("level %1\n%2 texels").arg(level).arg(cube.levelSize(level)));
    painter.drawImage(x, kHeading, faceImage(cube, level, map.face, size, exposure));
    painter.drawImage(x, kHeading + size + kMapGap, faceImage(means, level, map.face, size, exposure));
  }
  return picture;
}

/// Drawn again a width to either side: what crosses the map's edge goes on at the other.
class LookupPainter {
 public:
  LookupPainter(QPainter& painter, int width) : painter_(painter), width_(width) {}

  void draw(const QPointF& sampled, QPointF right) const {
    if (right.x() - sampled.x() > 0.5 * width_) right.rx() -= width_;
    if (sampled.x() - right.x() > 0.5 * width_) right.rx() += width_;
    for (const double shift : {-1.0, 0.0, 1.0}) {
      const QPointF by(shift * width_, 0.0);
      one(sampled + by, right + by);
    }
  }

 private:
  void one(const QPointF& sampled, const QPointF& right) const {
    constexpr double kDot = 4.0, kRing = 7.0;
    const QPointF way = right - sampled;
    const double length = std::hypot(way.x(), way.y());
    painter_.setBrush(Qt::NoBrush);
    for (const auto& [color, wider] : {std::pair(QColor(Qt::white), 2.5), std::pair(kRightPlace, 0.0)}) {
      painter_.setPen(QPen(color, 2.0 + wider));
      painter_.drawEllipse(right, kRing, kRing);
    }
    if (length > kRing) {
      const QPointF end = right - kRing / length * way;
      for (const auto& [color, wider] : {std::pair(QColor(Qt::white), 2.0), std::pair(kSampled, 0.0)}) {
        painter_.setPen(QPen(color, 1.8 + wider));
        painter_.drawLine(sampled, end);
      }
    }
    painter_.setPen(QPen(Qt::white, 1.5));
    painter_.setBrush(kSampled);
    painter_.drawEllipse(sampled, kDot, kDot);
  }

  QPainter& painter_;
  double width_;
};

QImage lookupsPicture(const PictureRegion& region, LessonPlayer& player, const CubeMap& cube, int width, int height) {
  std::vector<glm::ivec2> places;
  for (int row = 0; row < kLookupRows; ++row) {
    for (int column = 0; column < kLookupColumns; ++column) {
      const double x = region[0] + (column + 0.5) / kLookupColumns * (region[2] - region[0]);
      const double y = region[1] + (row + 0.5) / kLookupRows * (region[3] - region[1]);
      places.emplace_back(static_cast<int>(x * (width - 1)), static_cast<int>(y * (height - 1)));
    }
  }
  const CubePicture map(CubePictureKind::LatLong, width);
  QImage picture(width, height, QImage::Format_RGB888);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const int top = std::max((height - map.height()) / 2, 0);
  painter.drawImage(0, top, mapImage(drawCubePicture(cube, 0, map, static_cast<float>(player.scene().exposure))));
  QColor pale(Qt::white);
  pale.setAlphaF(kPaleness);
  painter.fillRect(0, top, map.width(), map.height(), pale);
  painter.setClipRect(0, top, map.width(), map.height());
  painter.translate(0, top);
  const LookupPainter lookups(painter, map.width());
  for (const Explanation& e : player.renderer().explain(places, width, height)) {
    if (!e.hit || e.dominant != 0 || !e.probes.front().trueDistance) continue;
    const ProbeExplanation& p = e.probes.front();
    const glm::mat3 toMap(p.mapFromProbe);
    const glm::dvec2 sampled = map.position(toMap * p.lookupDirection);
    const glm::dvec2 right = map.position(toMap * (p.positionProbe + *p.trueDistance * p.reflectionProbe));
    lookups.draw({sampled.x, sampled.y}, {right.x, right.y});
  }
  return picture;
}

}  // namespace

QImage mapPicture(const LessonMap& map, LessonPlayer& player, int width, int height) {
  const Scene& scene = player.scene();
  player.window()->MakeCurrent();
  const auto maps = scene.probes.empty() ? nullptr : player.renderer().mapsOnCpu(scene.probes.front().name);
  if (!maps) throw WorkError("a picture of a cubemap needs a probe, and the scene has none");
  if (map.lookups) return lookupsPicture(*map.lookups, player, maps->radiance, width, height);
  return levelsPicture(map, maps->radiance, static_cast<float>(scene.exposure), width, height);
}

}  // namespace boxprobe
