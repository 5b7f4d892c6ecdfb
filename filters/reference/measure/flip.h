// Differences between two pictures as an observer would see them when flipping between them: LDR-FLIP of Andersson,
// Nilsson, Akenine-Moeller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator for Alternating Images",
// HPG 2020, written from the paper. Called by the metrics; knows no renderer.
#pragma once

#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Pixels a degree of visual angle: a 0.7 m wide monitor of 3840 pixels seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67.0206;

/// One value per pixel, rows from the top: 0 (equal) to 1. Linear pictures of one size; each is brought into the
/// display's range by x / (1 + x) first, as all metrics here are, and taken as linear light with sRGB's primaries.
std::vector<float> flipMap(const ImageRgbaF& picture, const ImageRgbaF& reference,
                           double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace boxprobe
