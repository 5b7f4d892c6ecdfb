// Makes the texels of an environment picture radiance that textures hold: numbers, not negative, at most 65504, with
// hues and energies kept. Internal to this folder.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/io/cube/cube_file.h"

namespace boxprobe {

/// The largest half float, the limit of textures.
constexpr float kHalfMax = 65504.0f;
/// The largest radiance that is read: leaves room for sums over a picture.
constexpr float kMostRadiance = 1e30f;

/// Fills in texels that are not finite; alpha becomes 1 there. Infinity becomes the largest half float, or the texel's
/// brightest finite channel if that is more; -infinity 0. NaN takes the hue of its finite neighbours (`wraps`: the left
/// and right columns are neighbours), scaled to the texel's other channels. Counts them.
void repairNotFinite(ImageRgbaF& image, bool wraps, PictureRepairs& repairs);

/// Sets negative values to 0 and brings those above kMostRadiance down to that with their hue. Counts texels with
/// negative radiance, and texels beyond the largest half float.
void limitRadiance(ImageRgbaF& image, PictureRepairs& repairs);

/// Spreads what is beyond the largest half float over the directions around it, in the smallest disc that holds the
/// light, up to 30 degrees wide in radius: irradiance stays, a sun becomes larger. Light that does not fit is cut off
/// and its share is recorded. Texels of `image` are at the centres of cells.
void spreadBeyondHalf(ImageRgbaF& image, PictureRepairs& repairs);
void spreadBeyondHalf(CubeMap& cube, PictureRepairs& repairs);

}  // namespace boxprobe
