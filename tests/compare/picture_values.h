// A picture file as plain numbers: PNG and JPEG as display values, every part, level and channel of an OpenEXR file.
// Written apart from the project's own readers, because it judges them. Knows nothing of what the pictures show.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace boxprobe::compare {

struct PictureValues {
  bool display = false;                              ///< 8-bit display values from 0 to 255; otherwise linear floats
  std::map<std::string, std::vector<float>> planes;  ///< by "part/level/channel", rows from the top
  std::set<std::string> attributes;                  ///< names in the headers of an OpenEXR file
};

/// Does the name end in .png, .jpg or .exr?
bool isPictureName(const std::string& path);
/// Throws std::runtime_error if the file is not a readable picture.
PictureValues readPicture(const std::string& path);

struct PictureDifference {
  std::vector<std::string> missing;  ///< planes and attributes of the old picture that the new one lacks or resized
  double largest =
      0.0;  ///< display: in 1/255; linear: relative to the larger value, at least 1 % of the plane's largest
  std::size_t values = 0, differing = 0;
};
/// NaN equals NaN and an infinity itself; a NaN or an infinity against anything else differs infinitely.
PictureDifference difference(const PictureValues& before, const PictureValues& after);

}  // namespace boxprobe::compare
