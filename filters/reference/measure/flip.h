// Differences between two pictures as seen when flipping between them: LDR-FLIP of Andersson, Nilsson, Akenine-Moeller,
// Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG 2020, implemented from
// the paper.
#pragma once

#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Pixels per degree of visual angle: a 0.7 m wide monitor of 3840 pixels seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67.0206;

/// One value per pixel, rows from the top: 0 (equal) to 1. The pictures must have the same size; linear values are
/// compressed by x / (1 + x), as in all metrics here, and then taken as linear light with sRGB's primaries.
std::vector<float> flipMap(const ImageRgbaF& picture, const ImageRgbaF& reference,
                           double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace boxprobe
