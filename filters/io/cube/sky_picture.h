// The picture of a sky, whatever layout it has, as the latitude-longitude map that skies are drawn from.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// EXR or HDR. Pictures of a cube, found as for custom probes, are resampled; any other is taken as it is. Texels that
/// are not finite are 0 and counted in `*notFinite` when given. Throws InputError.
ImageRgbaF loadSkyPicture(const std::string& path, std::size_t* notFinite = nullptr);

}  // namespace boxprobe
