// One part of an OpenEXR file as float pixels: what pictures, cubes and baked probes are read through. Internal to this
// folder. Scan lines and tiles (the finest level), half, float and unsigned integers, any data window; deep data is
// refused in a sentence.
#pragma once

#include <OpenEXR/ImfMultiPartInputFile.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

enum class EnvmapKind { LatLong, Cube };

struct ExrPicture {
  ImageRgbaF image;             ///< the data window
  std::vector<float> distance;  ///< channel "distance", else "Z"; one value per pixel, or empty
  bool hasAlpha = false;
  std::optional<EnvmapKind> envmap;
  // Where the data window lies in the display window: a cropped picture, or one with overscan.
  int displayWidth = 0, displayHeight = 0;
  int offsetX = 0, offsetY = 0;
};

/// Runs `read` on the open file; whatever OpenEXR throws becomes one InputError naming `path`.
void withExrFile(const std::string& path, const std::function<void(Imf::MultiPartInputFile&)>& read);

/// The part that shows the surroundings: the first one with an envmap attribute, else the first flat picture.
int picturePart(const Imf::MultiPartInputFile& file, const std::string& path);

/// Throws InputError naming path, part and channel. Sizes are refused before anything is allocated for them.
ExrPicture readExrPart(Imf::MultiPartInputFile& file, int part, const std::string& path);

/// One channel of a part as float; its size as given, else InputError.
std::vector<float> readExrChannel(Imf::MultiPartInputFile& file, int part, const std::string& channel, int width,
                                  int height, const std::string& path);

}  // namespace boxprobe
