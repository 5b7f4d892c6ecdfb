// Reads a sky's picture in any layout as the latitude-longitude map from which skies are drawn.
#pragma once

#include "filters/core/scene/model.h"
#include "filters/io/cube/cube_file.h"

namespace boxprobe {

/// What was found out about a sky's picture.
struct SkyPictureNotes {
  CubeLayout layout = CubeLayout::LatLong;  ///< of the file
  PictureRepairs repairs;
};

/// EXR or HDR. Cube layouts, detected as for custom probes and seen from `image.cubeView`, are resampled; other
/// pictures are taken for latitude-longitude maps. No value is above 65504, the largest half float. Throws InputError.
ImageRgbaF loadSkyPicture(const SkyImage& image, SkyPictureNotes* notes = nullptr);

}  // namespace boxprobe
