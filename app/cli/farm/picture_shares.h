// A reference picture by many processes, on one machine or many: each traces a band of rows into a file beside the
// picture, and whoever finds all bands there puts the picture together. No word passes between them. A band names what
// it is of by a key, so that bands of another scene, camera or setting are never taken.
#pragma once

#include <optional>
#include <string>

#include "app/cli/farm/bake_share.h"
#include "filters/reference/light/progressive_picture.h"

namespace boxprobe {

/// Rows of share `index` of `count`: as many for each as can be; none for shares beyond the picture's rows.
PicturePart rowsOfShare(int width, int height, const BakeShare& share);

/// "FILE.3-of-8.0123456789abcdef.band.exr" for the picture FILE and what it shows.
std::string bandPath(const std::string& picture, const BakeShare& share, const std::string& key);

/// Colours and standard errors of the rows of `part`, written whole or not at all. Throws WorkError.
void saveBand(const std::string& path, const ReferencePicture& picture, const PicturePart& part);

struct JoinedBands {
  ReferencePicture picture;
  int missing = 0;         ///< bands that are not there; above 0 there is no picture
  bool elsewhere = false;  ///< another process took the bands away meanwhile: it has written the picture
};
/// All bands of a picture. Throws InputError for one that is damaged, saying how to make it again.
JoinedBands joinBands(const std::string& picture, int width, int height, int shares, const std::string& key);

/// Takes the bands away once their picture is written.
void removeBands(const std::string& picture, int shares, const std::string& key);

}  // namespace boxprobe
