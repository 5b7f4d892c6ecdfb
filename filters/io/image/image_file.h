// Reads and writes pictures: PNG for display colours, OpenEXR and Radiance HDR for linear ones. Every output is written
// to a temporary file beside its target and renamed.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

void savePng(const std::string& path, const ImageRgba8& image);
/// The PNG's bytes; `name` is for messages. Throws WorkError.
std::string encodePng(const std::string& name, const ImageRgba8& image);

/// An additional channel: one value per pixel, rows from the top.
struct ExtraChannel {
  std::string name;
  std::vector<float> values;
};

/// Float RGBA, ZIP compressed, scan lines.
void saveExr(const std::string& path, const ImageRgbaF& image, const std::vector<ExtraChannel>& extra = {});

/// Radiance HDR (RGBE, run lengths): 8 bits each for red, green and blue with a common exponent, no alpha. Throws
/// WorkError.
void saveRadiance(const std::string& path, const ImageRgbaF& image);

/// Chooses the format by extension, .exr or .hdr. Non-finite texels are set to 0 and counted in `*notFinite` if given.
/// Throws InputError.
ImageRgbaF loadHdrImage(const std::string& path, std::size_t* notFinite = nullptr);

/// 8-bit PNG, JPEG or WebP. `*hasAlpha` if given: does the file have an alpha channel? Without one alpha is 255. Throws
/// InputError.
ImageRgba8 loadImage8(const std::string& path, bool* hasAlpha = nullptr);

}  // namespace boxprobe
