// How far a picture is from an independent renderer's, and how far it may be: mean light and relative error over the
// floor, whole and by the angle it is seen under. Called by `bench --truth` and by tests; knows no renderer.
#pragma once

#include <string>
#include <vector>

#include "filters/reference/light/progressive_picture.h"
#include "filters/reference/truth/truth_index.h"

namespace boxprobe {

/// Pixels of the floor that are seen under similar angles.
struct TruthBucket {
  double nDotVLow = 0.0, nDotVHigh = 1.0;
  double meanLight = 1.0;
  double relativeRmse = 0.0;
  std::size_t pixels = 0;
};

/// One technique or reference against one truth picture.
struct TruthRow {
  std::string scene, camera, kind;
  double roughness = 0.0;
  std::string technique;      ///< label of a technique, or "reference-scene", "reference-box"
  double meanLight = 1.0;     ///< of the picture over that of the truth
  double relativeRmse = 0.0;  ///< root of the sum of squared differences over that of the truth's squares
  double noise = 0.0;         ///< joint, of both pictures: what relativeRmse is if they agree
  double texelCost = 0.0;     ///< relative RMS of what the texels of a captured radiance cost; 0: it has none
  double lightNoise = 0.0;    ///< joint standard error of meanLight
  std::size_t pixels = 0;
  std::vector<TruthBucket> buckets;

  bool reference() const { return technique.rfind("reference-", 0) == 0; }
  /// What references are held to: 3 times the joint noise, and what the texels cost.
  double largestRmse() const { return 3.0 * noise + texelCost; }
  /// |meanLight - 1|: 1 % of a metal, 3 % of a dielectric and a coat.
  double largestLightError() const { return kind == "dielectric" || kind == "coat" ? 0.03 : 0.01; }
  bool holds() const;
};

/// Does the floor cover all of this pixel of a truth picture?
bool coveredByFloor(const ImageRgbaF& truth, std::size_t pixel);

/// `drawn`: of the truth's size, what is not floor being of any colour. `standardError`: of each of its pixels; null:
/// it has no noise. Only pixels count that the floor covers and that are covered in `drawn`. Throws InputError if there
/// are none.
TruthRow compareWithTruth(const TruthIndex& index, const TruthPicture& picture, const Camera& camera,
                          const std::string& technique, const ImageRgbaF& drawn,
                          const ImageRgbaF* standardError = nullptr);

/// What texels cost, as relative RMS over the pixels that count: of pictures from a capture and from one of half its
/// resolution. An error in proportion to the texel is their difference, one in proportion to its square a third of it.
double texelCost(const ReferencePicture& picture, const ReferencePicture& coarser, const ImageRgbaF& truth);

/// Each pixel the mean of `factor` x `factor`.
ImageRgbaF boxAveraged(const ImageRgbaF& fine, int factor);

/// One line a technique, scene, kind and camera; by roughness the mean light, the relative RMSE and, of a reference,
/// what that may be. What a reference does not hold is marked by '!'.
std::string truthTable(const TruthIndex& index, const std::vector<TruthRow>& rows);
/// {"renderer", "complete", "rows": [{"scene", "camera", "kind", "roughness", "technique", "reference": "truth",
/// "meanLight", "relativeRmse", "noise", ...}]}
std::string truthJson(const TruthIndex& index, const std::vector<TruthRow>& rows, bool complete);

}  // namespace boxprobe
