// See picture_difference.h.
#include "app/gui/view/picture_difference.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "app/session/display_picture.h"
#include "filters/reference/bench/whole_picture.h"

namespace boxprobe {

double displayPsnr(const QImage& a, const QImage& b) {
  double squares = 0.0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      for (const int d : {qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q)}) squares += d * d;
    }
  }
  if (squares == 0.0) return std::numeric_limits<double>::infinity();
  return 10.0 * std::log10(255.0 * 255.0 * 3.0 * a.width() * a.height() / squares);
}

std::optional<LightDifference> lightDifference(const ImageRgbaF& picture, const ReferencePicture& truth) {
  const ImageRgbaF& traced = truth.color;
  if (picture.pixels.empty() || picture.width != traced.width || picture.height != traced.height) return std::nullopt;
  // Of pixels that nothing is known of all are in one part.
  const std::vector<PartError> parts = partErrors(picture, truth, std::vector<SeenPoint>(traced.pixels.size() / 4));
  return LightDifference{parts.front().light, parts.front().relativeRmse, parts.front().noise};
}

QString lightText(const LightDifference& difference) {
  const QString text = QCoreApplication::translate("PictureDifference", "light %1, RMSE %2")
                           .arg(difference.light, 0, 'f', 2)
                           .arg(difference.relativeRmse, 0, 'f', 2);
  if (difference.noise < 0.1 * difference.relativeRmse) return text;
  return text + QCoreApplication::translate("PictureDifference", ", noise %1").arg(difference.noise, 0, 'f', 2);
}

QColor differenceColor(double difference) {
  const std::array<std::uint8_t, 3> bytes = differenceBytes(difference);
  return {bytes[0], bytes[1], bytes[2]};
}

PictureDifference pictureDifference(const QImage& a, const QImage& b) {
  PictureDifference difference;
  const QImage p = a.convertToFormat(QImage::Format_RGB32), q = b.convertToFormat(QImage::Format_RGB32);
  std::array<QRgb, 256> colors{};
  for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = differenceColor(static_cast<double>(i) / 255.0).rgb();
  std::array<long, 256> counts{};
  difference.picture = QImage(p.size(), QImage::Format_RGB32);
  for (int y = 0; y < p.height(); ++y) {
    const auto* first = reinterpret_cast<const QRgb*>(p.constScanLine(y));
    const auto* second = reinterpret_cast<const QRgb*>(q.constScanLine(y));
    auto* row = reinterpret_cast<QRgb*>(difference.picture.scanLine(y));
    for (int x = 0; x < p.width(); ++x) {
      const auto most = static_cast<std::size_t>(
          std::max({std::abs(qRed(first[x]) - qRed(second[x])), std::abs(qGreen(first[x]) - qGreen(second[x])),
                    std::abs(qBlue(first[x]) - qBlue(second[x]))}));
      row[x] = colors[most];
      ++counts[most];
      difference.mean += static_cast<double>(most) / 255.0;
    }
  }
  const long all = static_cast<long>(p.width()) * p.height();
  if (all == 0) return difference;
  difference.mean /= static_cast<double>(all);
  long below = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    below += counts[i];
    difference.mostOf95 = static_cast<double>(i) / 255.0;
    if (static_cast<double>(below) >= 0.95 * static_cast<double>(all)) break;
  }
  return difference;
}

}  // namespace boxprobe
