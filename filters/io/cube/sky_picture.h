// Reads a sky's picture in any layout as the latitude-longitude map from which skies are drawn.
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/cube/cube_file.h"

namespace boxprobe {

/// EXR or HDR. Cube layouts, detected as for custom probes, are resampled; other pictures are taken for
/// latitude-longitude maps. No value is above 65504, the largest half float. `*repairs` if given: what was changed.
/// Throws InputError.
ImageRgbaF loadSkyPicture(const std::string& path, PictureRepairs* repairs = nullptr);

}  // namespace boxprobe
