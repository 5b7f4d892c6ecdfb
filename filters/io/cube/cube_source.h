// An environment picture before its conversion to a cube: read, invalid values replaced, its layout detected. Internal
// to this folder.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/scene.h"
#include "filters/io/cube/picture_code.h"
#include "filters/io/image/exr_reader.h"

namespace boxprobe {

/// The largest half float, the limit of textures.
constexpr float kHalfMax = 65504.0f;

struct CubeSource {
  std::string path;
  ExrPicture picture;
  std::size_t texelsNotFinite = 0;
  std::size_t texelsClamped = 0;
};

/// EXR or HDR; for encodings other than Linear, PNG or JPEG. Throws InputError.
CubeSource readCubeSource(const std::string& path, const PictureCode& code);

/// From the envmap attribute, else the shape of the data window, else that of the display window, to which the picture
/// is then padded or cropped. Automatic if none fits.
CubeLayout detectLayout(CubeSource& source);

/// Automatic if none fits.
CubeLayout layoutOfShape(long long width, long long height);

/// "64 x 384 pixels"
std::string sizeText(int width, int height);

}  // namespace boxprobe
