// Compares pictures with an independent renderer's: mean light and relative error over the floor, overall and by view
// angle, with the allowed errors.
#pragma once

#include <string>
#include <vector>

#include "filters/reference/light/progressive_picture.h"
#include "filters/reference/truth/truth_index.h"

namespace boxprobe {

/// Floor pixels seen under similar angles.
struct TruthBucket {
  double nDotVLow = 0.0, nDotVHigh = 1.0;
  double meanLight = 1.0;
  double relativeRmse = 0.0;
  std::size_t pixels = 0;
};

/// One technique or reference against one picture of the independent renderer.
struct TruthRow {
  std::string scene, camera, kind;
  double roughness = 0.0;
  std::string technique;      ///< label of a technique, or "reference-scene", "reference-box"
  double meanLight = 1.0;     ///< of the picture over that of the independent one
  double relativeRmse = 0.0;  ///< root of the sum of squared differences over that of the independent picture's squares
  double noise = 0.0;         ///< of both pictures together: the expected relativeRmse if they agree
  double texelCost = 0.0;     ///< relative RMS of the error from a capture's resolution; 0: without a capture
  double lightNoise = 0.0;    ///< joint standard error of meanLight
  std::size_t pixels = 0;
  std::vector<TruthBucket> buckets;

  bool reference() const { return technique.rfind("reference-", 0) == 0; }
  /// The bound for references: 3 times the joint noise, plus the resolution's error.
  double largestRmse() const { return 3.0 * noise + texelCost; }
  /// The bound of |meanLight - 1|: 1 % for a metal, 3 % for a dielectric and a coat.
  double largestLightError() const { return kind == "dielectric" || kind == "coat" ? 0.03 : 0.01; }
  bool holds() const;
};

/// Does the floor cover this pixel entirely?
bool coveredByFloor(const ImageRgbaF& truth, std::size_t pixel);

/// `drawn`: of the same size; pixels other than the floor are ignored. `standardError`: of each of its pixels; null: no
/// noise. Counts pixels that the floor covers and that are covered in `drawn`. Throws InputError if there are none.
TruthRow compareWithTruth(const TruthIndex& index, const TruthPicture& picture, const Camera& camera,
                          const std::string& technique, const ImageRgbaF& drawn,
                          const ImageRgbaF* standardError = nullptr);

/// The error from a capture's resolution, as relative RMS, from pictures with a capture and with one of half its
/// resolution. For an error proportional to the texel size it is their difference; for a quadratic one, a third of
/// that.
double texelCost(const ReferencePicture& picture, const ReferencePicture& coarser, const ImageRgbaF& truth);

/// Each pixel is the mean of `factor` x `factor` pixels.
ImageRgbaF boxAveraged(const ImageRgbaF& fine, int factor);

/// One line per technique, scene, kind and camera; for each roughness the mean light, the relative RMSE and, for a
/// reference, its bound. Exceeded bounds are marked by '!'.
std::string truthTable(const TruthIndex& index, const std::vector<TruthRow>& rows);
/// {"renderer", "complete", "rows": [{"scene", "camera", "kind", "roughness", "technique", "reference": "truth",
/// "meanLight", "relativeRmse", "noise", ...}]}
std::string truthJson(const TruthIndex& index, const std::vector<TruthRow>& rows, bool complete);

}  // namespace boxprobe
