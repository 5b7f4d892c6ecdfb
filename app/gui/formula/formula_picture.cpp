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

QString formulaSvg(const QString& mathml) {
  constexpr double kUnits = 500.0;  // an em: finer than a pixel of the largest letters a page has
  const MathBox box = layoutMathml(mathml);
  const auto whole = [](double ems) { return static_cast<int>(std::lround(ems * kUnits)); };
  const QRectF ink = box.path.boundingRect();
  const int left = whole(std::min(ink.left(), 0.0)), right = whole(std::max(ink.right(), box.width));
  const int top = whole(std::min(ink.top(), -0.7)), bottom = whole(std::max(ink.bottom(), 0.2));
  // Relative to the point before, which is half as long; from rounded points, so that nothing adds up.
  QString outlines;
  int x = 0, y = 0, inCurve = 0, fromX = 0, fromY = 0;
  for (int i = 0; i < box.path.elementCount(); ++i) {
    const QPainterPath::Element element = box.path.elementAt(i);
    const int toX = whole(element.x), toY = whole(element.y);
    if (element.type == QPainterPath::MoveToElement) outlines += (i > 0 ? QStringLiteral("z") : QString());
    if (element.type == QPainterPath::CurveToElement) {
      outlines += 'c';
      inCurve = 3;
      fromX = x;
      fromY = y;
    }
    if (inCurve > 0) {
      outlines += QString::number(toX - fromX) + ' ' + QString::number(toY - fromY) + (--inCurve > 0 ? " " : "");
    } else if (element.type == QPainterPath::MoveToElement) {
      outlines += 'M' + QString::number(toX) + ' ' + QString::number(toY);
    } else {
      outlines += 'l' + QString::number(toX - x) + ' ' + QString::number(toY - y);
    }
    x = toX;
    y = toY;
  }
  outlines.replace(" -", "-");
  const auto ems = [](int units) { return QString::number(units / kUnits, 'f', 3); };
  return QStringLiteral(
             "<svg aria-hidden=\"true\" viewBox=\"%1 %2 %3 %4\" "
             "style=\"width:%5em;height:%6em;vertical-align:%7em\"><path%8 d=\"%9z\"/></svg>")
      .arg(left)
      .arg(top)
      .arg(right - left)
      .arg(bottom - top)
      .arg(ems(right - left), ems(bottom - top), ems(-bottom))
      .arg(box.path.fillRule() == Qt::OddEvenFill ? QStringLiteral(" fill-rule=\"evenodd\"") : QString(), outlines);
}

}  // namespace boxprobe
