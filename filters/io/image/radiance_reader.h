// Reads Radiance HDR pictures as their headers mean them. stb_image reads none of this: old run lengths (it takes them
// for pixels), EXPOSURE, COLORCORR, PRIMARIES, XYZE, rows from the bottom or columns first, headers without FORMAT or
// with a line above 1023 bytes; and it reads past the end of incomplete rows. Internal to this folder.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

struct RadiancePicture {
  ImageRgbaF image;                  ///< linear Rec. 709, before any exposure, rows from the top; alpha 1
  std::vector<std::string> remarks;  ///< lines of the header that are not followed
};

/// `bytes`: the whole file; `name` stands for it in messages. Time and memory are proportional to the pixels that are
/// there: none is allocated for rows that the file lacks. Values may be infinite or negative (EXPOSURE, XYZE). Throws
/// InputError.
RadiancePicture decodeRadiance(const std::string& bytes, const std::string& name);

}  // namespace boxprobe
