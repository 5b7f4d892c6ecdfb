// A sheet of a benchmark's pictures: the truth, each technique's picture and under it where it is wrong. Called by
// bench_command; knows no scene.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

struct ContactPicture {
  std::string label;
  ImageRgbaF picture;        ///< linear
  std::vector<float> error;  ///< a value per pixel, rows from the top; negative: not measured there
};

/// `exposure` as in the scene. The first cell shows the truth and the scale of the error pictures, which all have the
/// range of 0 to `range`. Throws WorkError where letters cannot be drawn.
ImageRgba8 contactSheet(const std::string& title, const ImageRgbaF& truth, const std::vector<ContactPicture>& pictures,
                        double exposure, double range);

}  // namespace boxprobe
