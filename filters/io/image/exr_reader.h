// Reads one part of an OpenEXR file as float pixels, for pictures, cubes and baked probes. Internal to this folder.
// Supports scan lines and tiles (the finest level), half, float and unsigned integers, any data window; deep data is
// refused.
#pragma once

#include <OpenEXR/ImfMultiPartInputFile.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/io/image/color_primaries.h"

namespace boxprobe {

enum class EnvmapKind { LatLong, Cube };

struct ExrPicture {
  ImageRgbaF image;             ///< the data window
  std::vector<float> distance;  ///< channel "distance", else "Z"; one value per pixel, or empty
  bool hasAlpha = false;
  std::optional<EnvmapKind> envmap;
  // Position of the data window in the display window: a cropped picture, or one with overscan.
  int displayWidth = 0, displayHeight = 0;
  int offsetX = 0, offsetY = 0;
  std::optional<ColorPrimaries> primaries;  ///< of the stored values; nothing: Rec. 709, or grey
  std::vector<std::string> remarks;         ///< what the header asks for and does not get
};

/// Runs `read` on the open file; converts whatever OpenEXR throws to one InputError with `path`.
void withExrFile(const std::string& path, const std::function<void(Imf::MultiPartInputFile&)>& read);

/// The part with the environment: the first one with an envmap attribute, else the first flat picture, else the first
/// with a layer of colours.
int picturePart(const Imf::MultiPartInputFile& file, const std::string& path);

/// Values as stored. Channels R, G, B and A, in lower case or of a layer ("ViewLayer.Combined.R"); Y, RY and BY as
/// the colours they stand for; a single channel as grey. Throws InputError with path, part and channel. Excessive sizes
/// are refused before memory is allocated.
ExrPicture readExrPart(Imf::MultiPartInputFile& file, int part, const std::string& path);

/// Converts the picture to Rec. 709 if its primaries are others.
void convertToRec709(ExrPicture& picture);

/// One channel of a part as float; throws InputError unless it has the given size.
std::vector<float> readExrChannel(Imf::MultiPartInputFile& file, int part, const std::string& channel, int width,
                                  int height, const std::string& path);

}  // namespace boxprobe
