// Reads a sky's picture in any layout as the latitude-longitude map from which skies are drawn.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// EXR or HDR. Cube layouts, detected as for custom probes, are resampled; other pictures are used as they are. Texels
/// that are not finite are set to 0 and counted in `*notFinite` if given. Throws InputError.
ImageRgbaF loadSkyPicture(const std::string& path, std::size_t* notFinite = nullptr);

}  // namespace boxprobe
