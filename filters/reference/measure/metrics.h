// How far a picture is from a reference: the measures of the benchmark. Called by it and by tests; knows no renderer.
#pragma once

#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Linear pictures of one size; `mask` empty (every pixel counts) or one entry per pixel. Alpha does not count.
struct PictureError {
  /// Root of the mean squared difference of (x / (1 + x))^(1/2.2), over pixels and components: the study's measure.
  double toneMappedRmse = 0.0;
  /// Root of the sum of squared differences over the root of the sum of squares of the reference. 0 for black on black,
  /// infinite for anything else on a black reference.
  double relativeRmse = 0.0;
  /// Mean of the picture over mean of the reference, all components together; 1 for black on black.
  double brightnessRatio = 1.0;
  /// Mean of flipMap() over the mask.
  double flip = 0.0;
  std::size_t pixels = 0;  ///< that counted
};

/// Throws InputError if the sizes differ or no pixel counts.
PictureError pictureError(const ImageRgbaF& picture, const ImageRgbaF& reference, const std::vector<bool>& mask = {});

/// (x / (1 + x))^(1/2.2), what is not positive becoming 0.
double toneMapped(double linear);

}  // namespace boxprobe
