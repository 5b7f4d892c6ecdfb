// An environment picture before its conversion to a cube: linear Rec. 709, no value invalid, its layout detected.
// Internal to this folder.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "filters/core/scene/scene.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/cube/picture_code.h"
#include "filters/io/cube/sky_sun.h"
#include "filters/io/image/exr_reader.h"

namespace boxprobe {

struct CubeSource {
  std::string path;
  ExrPicture picture;
  PictureRepairs repairs;  ///< what is beyond half floats is counted, not yet spread
};

/// EXR or HDR; for encodings other than Linear, PNG or JPEG. Throws InputError.
CubeSource readCubeSource(const std::string& path, const PictureCode& code);

/// From the envmap attribute, which is about the data window, else the shape of the display window, to which the
/// picture is then padded or cropped, else that of the data window. Automatic if none fits.
CubeLayout detectLayout(CubeSource& source);

/// Automatic if none fits.
CubeLayout layoutOfShape(long long width, long long height);

/// Pads with black, or crops, to the display window, if the header gives one of another place or size. Throws
/// InputError if that is too large.
void fillDisplayWindow(CubeSource& source);

/// A sky that is a cube, at its own resolution, as loadCube() reads it. `sun`: receives what takeSun() finds, before
/// what is beyond half floats is spread; null: it stays. Throws InputError.
LoadedCube loadSkyCube(const std::string& path, CubeLayout layout, CubeView view, std::optional<SkySun>* sun);

/// "64 x 384 pixels"
std::string sizeText(int width, int height);

}  // namespace boxprobe
