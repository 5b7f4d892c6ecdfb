// Reads a sky's picture in any layout as the latitude-longitude map from which skies are drawn.
#pragma once

#include "filters/core/scene/model.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/cube/sky_sun.h"

namespace boxprobe {

/// What was found out about a sky's picture.
struct SkyPictureNotes {
  CubeLayout layout = CubeLayout::LatLong;  ///< of the file
  PictureRepairs repairs;
};

/// EXR or HDR. Cube layouts, detected as for custom probes and seen from `image.cubeView`, are resampled; other
/// pictures are taken for latitude-longitude maps. No value is above 65504, the largest half float. Throws InputError.
ImageRgbaF loadSkyPicture(const SkyImage& image, SkyPictureNotes* notes = nullptr);

/// A sky as it is drawn.
struct DrawnSky {
  ImageRgbaF image;           ///< without the sun
  std::optional<SkySun> sun;  ///< that is drawn as a light; none unless image.sun asks for it
  SkyPictureNotes notes;
};
/// As loadSkyPicture, and the same picture where no sun is taken out. Throws InputError.
DrawnSky loadDrawnSky(const SkyImage& image);

}  // namespace boxprobe
