// Decodes RGBM and double LDR, which store high dynamic range in eight bits, to linear radiance
// (filters/math/cube/rgbm.h).
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// The encoding of a picture's texels: a custom probe's `encoding` and `decode`.
struct PictureCode {
  ImageEncoding encoding = ImageEncoding::Linear;
  std::optional<glm::dvec2> decode;  ///< multiplier and exponent; nothing: usualDecode()

  bool operator==(const PictureCode& o) const { return encoding == o.encoding && decode == o.decode; }
};

/// The usual instruction (multiplier, exponent) of an encoding. Rgbm: (34.493242, 2.2) and Dldr: (4.594793, 1), Unity's
/// in linear colour, 5^2.2 and 2^2.2 (manual, "Lightmaps: technical information"; EntityLighting.hlsl of its render
/// pipelines). RgbmLinear: (5, 1). Linear: (1, 1).
glm::dvec2 usualDecode(ImageEncoding encoding);

/// Linear radiance of a PNG or, for Dldr, a JPEG; alpha 1. Throws InputError for other formats, and for RGBM without an
/// alpha channel, which holds its multiplier.
ImageRgbaF loadEncodedImage(const std::string& path, const PictureCode& code);

}  // namespace boxprobe
