// See display_image.h.
#include "app/gui/view/display_image.h"

#include <array>

#include "filters/math/shared/display_math.h"

namespace boxprobe {

QImage displayImage(const ImageRgbaF& linear, double exposure, Tone tone) {
  if (linear.pixels.empty()) return {};
  QImage image(linear.width, linear.height, QImage::Format_RGB32);
  std::size_t at = 0;
  for (int y = 0; y < linear.height; ++y) {
    auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < linear.width; ++x, at += 4) {
      const float* p = &linear.pixels[at];
      const std::array<std::uint8_t, 3> shown = displayBytes({p[0], p[1], p[2]}, exposure, tone);
      row[x] = qRgb(shown[0], shown[1], shown[2]);
    }
  }
  return image;
}

}  // namespace boxprobe
