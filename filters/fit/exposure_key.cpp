// See exposure_key.h.
#include "filters/fit/exposure_key.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

namespace {

/// The grey that a tone curve displays as `shown`; both linear.
double greyShownAs(double shown, Tone tone) {
  double low = 0.0, high = 64.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (toneMapped(glm::vec3(static_cast<float>(middle)), tone).y < shown ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double keyedExposure(const ImageRgbaF& picture, bool skyToo, Tone tone) {
  const bool cutOff = tone == Tone::None || tone == Tone::AsVtk;
  const double kMiddle = greyShownAs(0.20, tone);                  // 0.48 in display values
  const double kBright = greyShownAs(cutOff ? 0.72 : 0.85, tone);  // 0.87, 0.93
  constexpr float kCovered = 0.5f;
  std::vector<float> luminances;
  for (std::size_t i = 0; i + 3 < picture.pixels.size(); i += 4) {
    const float* p = &picture.pixels[i];
    const float luminance = 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
    if ((skyToo || p[3] > kCovered) && std::isfinite(luminance)) luminances.push_back(luminance);
  }
  if (luminances.size() < 16) return 1.0;
  const auto percentile = [&](double share) {
    const auto at =
        luminances.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(luminances.size() - 1));
    std::nth_element(luminances.begin(), at, luminances.end());
    return static_cast<double>(*at);
  };
  const double bright = percentile(0.95), median = percentile(0.5);
  if (!(bright > 0.0)) return 1.0;
  const double exposure = std::min(kBright / bright, median > 0.0 ? kMiddle / median : kBright / bright);
  const double digits = std::pow(10.0, std::floor(std::log10(exposure)) - 2.0);
  return std::round(exposure / digits) * digits;
}

}  // namespace boxprobe
