// The pictures of all light that an independent path tracer (Cycles) made of the scenes in this folder, and how far
// another picture is from one of them. Called by the tests beside it; knows no renderer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

struct LitPicture {
  std::string file;  ///< in the folder `pictures`
  std::string scene, camera;
  std::optional<int> bounces;  ///< after the first surface; none: all
  int samples = 0;             ///< of each of the two pictures it is the mean of
  double noise = 0.0;          ///< relative RMS over blocks, by two seeds

  std::string bounceText() const { return bounces ? std::to_string(*bounces) : "all"; }
};

struct LitIndex {
  std::string renderer;
  int width = 0, height = 0;
  int block = 1;  ///< pixels a side of the blocks that pictures are compared over
  std::vector<LitPicture> pictures;

  static std::string folder();
  std::string scenePath(const std::string& scene) const;
};

LitIndex loadLitIndex();
/// Throws InputError for a picture that is not there or has another size than the index says.
ImageRgbaF loadLitPicture(const LitIndex& index, const LitPicture& picture);

/// Of one picture, given twice with independent noise, against the truth.
struct LitError {
  double meanLight = 1.0;     ///< over the truth's
  double lightNoise = 0.0;    ///< standard error of meanLight
  double relativeRmse = 0.0;  ///< over blocks, what the noise of both makes of it taken off
  double noise = 0.0;         ///< relative RMS of the given picture's own, over blocks
  /// Light of the darker half of the blocks over the truth's there: a patch of sun outshines a room that is lit
  /// wrongly. 1 for black on black, infinite for other light on black.
  double dimLight = 1.0;
  double dimNoise = 0.0;  ///< standard error of dimLight at most: as if the truth's noise were all in that half
};

/// `first`, `second`: the same estimate with independent noise; their mean is judged. Root of the sum of squared
/// differences of blocks over that of the truth's squares; the noise of either side is known by two seeds, its square
/// is taken off. Negative differences count as 0.
LitError litError(const LitIndex& index, const LitPicture& picture, const ImageRgbaF& truth, const ImageRgbaF& first,
                  const ImageRgbaF& second);

}  // namespace boxprobe
