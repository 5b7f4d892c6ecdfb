// See pictures.h.
#include "tests/gui/pictures.h"

#include <QColor>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/gui/view/viewport.h"

namespace boxprobe {

namespace {

int largestDifference(QRgb a, QRgb b) {
  return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF ab = b - a;
  const double length2 = QPointF::dotProduct(ab, ab);
  const double t = length2 > 0.0 ? std::clamp(QPointF::dotProduct(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  const QPointF d = p - (a + t * ab);
  return std::hypot(d.x(), d.y());
}

}  // namespace

QImage shownPicture(Viewport& viewport) {
  return viewport.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

double differingShare(const QImage& a, const QImage& b, int tolerance) {
  if (a.size() != b.size() || a.isNull()) return 1.0;
  int differing = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x)
      differing += largestDifference(a.pixel(x, y), b.pixel(x, y)) > tolerance ? 1 : 0;
  }
  return static_cast<double>(differing) / (static_cast<double>(a.width()) * a.height());
}

int pixelsNear(const QImage& image, const QPointF& from, const QPointF& to, double radius, const QColor& color,
               int tolerance) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (distanceToSegment({x + 0.5, y + 0.5}, from, to) > radius) continue;
      if (largestDifference(image.pixel(x, y), color.rgb()) <= tolerance) ++count;
    }
  }
  return count;
}

}  // namespace boxprobe
