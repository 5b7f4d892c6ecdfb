#include "filters/reference/measure/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/reference/measure/flip.h"

namespace boxprobe {

double toneMapped(double linear) {
  const double x = std::max(linear, 0.0);
  // x / (1 + x) of infinity is 1; the division would give NaN.
  return std::isinf(x) ? 1.0 : std::pow(x / (1.0 + x), 1.0 / 2.2);
}

PictureError pictureError(const ImageRgbaF& picture, const ImageRgbaF& reference, const std::vector<bool>& mask) {
  const auto size = [](const ImageRgbaF& i) { return std::to_string(i.width) + " x " + std::to_string(i.height); };
  if (picture.width != reference.width || picture.height != reference.height) {
    throw InputError("a picture of " + size(picture) + " pixels cannot be compared with a reference of " +
                     size(reference) + "; render both at one size");
  }
  const std::vector<float> flip = flipMap(picture, reference);
  PictureError error;
  double toneMappedSum = 0.0, squares = 0.0, referenceSquares = 0.0, sum = 0.0, referenceSum = 0.0, flipSum = 0.0;
  for (std::size_t i = 0; i < flip.size(); ++i) {
    if (!mask.empty() && !mask.at(i)) continue;
    ++error.pixels;
    flipSum += flip[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const double a = picture.pixels[4 * i + c], b = reference.pixels[4 * i + c];
      const double d = toneMapped(a) - toneMapped(b);
      toneMappedSum += d * d;
      squares += (a - b) * (a - b);
      referenceSquares += b * b;
      sum += a;
      referenceSum += b;
    }
  }
  if (error.pixels == 0) throw InputError("no pixel to compare: the mask covers the whole picture");
  const auto quotient = [](double a, double b, double both) {
    return b > 0.0 ? a / b : a > 0.0 ? std::numeric_limits<double>::infinity() : both;
  };
  error.toneMappedRmse = std::sqrt(toneMappedSum / static_cast<double>(3 * error.pixels));
  error.relativeRmse = std::sqrt(quotient(squares, referenceSquares, 0.0));
  error.brightnessRatio = quotient(sum, referenceSum, 1.0);
  error.flip = flipSum / static_cast<double>(error.pixels);
  return error;
}

}  // namespace boxprobe
