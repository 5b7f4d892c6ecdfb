// The benchmark's measures of a picture's error.
#pragma once

#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Linear pictures of one size; `mask` is empty (all pixels count) or has one entry per pixel. Alpha is ignored.
struct PictureError {
  /// RMS difference of (x / (1 + x))^(1/2.2), over pixels and components.
  double toneMappedRmse = 0.0;
  /// Root of the sum of squared differences over the root of the reference's sum of squares. 0 for black on black,
  /// infinite for anything else on a black reference.
  double relativeRmse = 0.0;
  /// Mean of the picture over mean of the reference, over all components; 1 for black on black.
  double brightnessRatio = 1.0;
  /// Mean of flipMap() over the mask.
  double flip = 0.0;
  std::size_t pixels = 0;  ///< number of pixels that counted
};

/// Throws InputError if the sizes differ or no pixel counts.
PictureError pictureError(const ImageRgbaF& picture, const ImageRgbaF& reference, const std::vector<bool>& mask = {});

/// (x / (1 + x))^(1/2.2); 0 for values that are not positive.
double toneMapped(double linear);

}  // namespace boxprobe
