// See formula_picture.h.
#include "app/gui/formula/formula_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/gui/formula/mathml_layout.h"

namespace boxprobe {

QImage formulaPicture(const QString& mathml, double pointSize, const QColor& color, double scale) {
  const MathBox box = layoutMathml(mathml);
  constexpr double kPixelsPerPoint = 96.0 / 72.0;
  constexpr double kMargin = 2.0;  // pixels: antialiased edges must not be cut
  const double em = pointSize * kPixelsPerPoint * scale;
  const QRectF ink = box.path.boundingRect();
  const auto pixels = [&](double ems) { return std::max(static_cast<int>(std::ceil(ems * em + 2.0 * kMargin)), 1); };
  QImage image(pixels(ink.width()), pixels(ink.height()), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  image.setDevicePixelRatio(1.0);
  {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(kMargin, kMargin);
    painter.scale(em, em);
    painter.translate(-ink.topLeft());
    painter.fillPath(box.path, color);
  }
  image.setDevicePixelRatio(scale);
  return image;
}

}  // namespace boxprobe
