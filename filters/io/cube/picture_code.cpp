#include "filters/io/cube/picture_code.h"

#include <glm/vec3.hpp>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/image/image_file.h"
#include "filters/math/cube/rgbm.h"

namespace boxprobe {

glm::dvec2 usualDecode(ImageEncoding encoding) {
  if (encoding == ImageEncoding::Rgbm) return {34.493242, 2.2};
  if (encoding == ImageEncoding::Dldr) return {4.594793, 1.0};
  return {encoding == ImageEncoding::RgbmLinear ? 5.0 : 1.0, 1.0};
}

ImageRgbaF loadEncodedImage(const std::string& path, const PictureCode& code) {
  const std::string extension = lowerExtension(path);
  if (extension == ".exr" || extension == ".hdr") {
    throw InputError(path + ": holds radiance as it is; take \"encoding\" away, or name the PNG that is encoded");
  }
  bool hasAlpha = false;
  const ImageRgba8 bytes = loadImage8(path, &hasAlpha);
  const bool dldr = code.encoding == ImageEncoding::Dldr;
  if (!dldr && !hasAlpha) {
    throw InputError(path +
                     ": has no alpha channel, which holds the multiplier of RGBM; save it as a PNG with alpha, or use "
                     "encoding \"dldr\"");
  }
  const glm::dvec2 decode = code.decode.value_or(usualDecode(code.encoding));
  const RgbmInstruction instruction{static_cast<float>(decode.x), static_cast<float>(decode.y),
                                    code.encoding != ImageEncoding::RgbmLinear};
  ImageRgbaF image;
  image.width = bytes.width;
  image.height = bytes.height;
  image.pixels.reserve(bytes.pixels.size());
  for (std::size_t i = 0; i < bytes.pixels.size(); i += 4) {
    const std::uint8_t* texel = &bytes.pixels[i];
    const std::uint8_t m = dldr ? 255 : texel[3];
    const glm::vec3 radiance = decodeRgbm({texel[0], texel[1], texel[2], m}, instruction);
    image.pixels.insert(image.pixels.end(), {radiance.r, radiance.g, radiance.b, 1.0f});
  }
  return image;
}

}  // namespace boxprobe
