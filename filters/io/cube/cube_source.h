// A picture of the surroundings before it is a cube: read, its values put right, its layout found. Internal to this
// folder.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/scene.h"
#include "filters/io/cube/picture_code.h"
#include "filters/io/image/exr_reader.h"

namespace boxprobe {

/// Largest half float: what textures hold.
constexpr float kHalfMax = 65504.0f;

struct CubeSource {
  std::string path;
  ExrPicture picture;
  std::size_t texelsNotFinite = 0;
  std::size_t texelsClamped = 0;
};

/// EXR or HDR; with another code than Linear, PNG or JPEG. Throws InputError.
CubeSource readCubeSource(const std::string& path, const PictureCode& code);

/// By the envmap attribute, else by the shape of the data window, else by the display window's, to which the picture is
/// then filled up or cut. Automatic where none fits.
CubeLayout detectLayout(CubeSource& source);

/// Automatic where none fits.
CubeLayout layoutOfShape(long long width, long long height);

/// "64 x 384 pixels"
std::string sizeText(int width, int height);

}  // namespace boxprobe
