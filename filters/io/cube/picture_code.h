// Eight-bit pictures that stand for more than eight bits hold: RGBM and double LDR, decoded to linear radiance. Called
// where pictures of the surroundings are read; the formula is filters/math/cube/rgbm.h's.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// What a picture's texels stand for: a custom probe's `encoding` and `decode`.
struct PictureCode {
  ImageEncoding encoding = ImageEncoding::Linear;
  std::optional<glm::dvec2> decode;  ///< multiplier and exponent; nothing: usualDecode()

  bool operator==(const PictureCode& o) const { return encoding == o.encoding && decode == o.decode; }
};

/// The instruction (multiplier, exponent) that a picture of this encoding has where nobody says so. Rgbm: (34.493242,
/// 2.2) and Dldr: (4.594793, 1), Unity's in linear colour, 5^2.2 and 2^2.2 (manual, "Lightmaps: technical information";
/// EntityLighting.hlsl of its render pipelines). RgbmLinear: (5, 1). Linear: (1, 1).
glm::dvec2 usualDecode(ImageEncoding encoding);

/// Linear radiance of a PNG or, as Dldr, a JPEG; alpha 1. Throws InputError: for a picture of another kind, and for
/// RGBM without an alpha channel, where its multiplier is.
ImageRgbaF loadEncodedImage(const std::string& path, const PictureCode& code);

}  // namespace boxprobe
