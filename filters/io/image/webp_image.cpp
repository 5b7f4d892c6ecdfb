#include "filters/io/image/webp_image.h"

#include <webp/decode.h>

#include <cstring>

#include "filters/core/base/errors.h"
#include "filters/io/image/image_detail.h"

namespace boxprobe {

bool isWebp(const unsigned char* bytes, std::size_t size) {
  return size >= 12 && std::memcmp(bytes, "RIFF", 4) == 0 && std::memcmp(bytes + 8, "WEBP", 4) == 0;
}

ImageRgba8 decodeWebp(const unsigned char* bytes, std::size_t size, const std::string& name, bool* hasAlpha) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes, size, &features) != VP8_STATUS_OK) {
    throw InputError(name + ": is a damaged WebP picture; save it again");
  }
  if (features.has_animation != 0) throw InputError(name + ": is an animated WebP picture; save one frame of it");
  checkImageSize(name, features.width, features.height);
  // A lossless picture of one colour has 25,000 pixels per byte.
  constexpr long long kWebpPixelsAByte = 1 << 15;
  checkEncodedSize(name, features.width, features.height, size, kWebpPixelsAByte);
  ImageRgba8 image;
  image.name = name;
  image.width = features.width;
  image.height = features.height;
  image.pixels.resize(std::size_t(4) * features.width * features.height);
  if (WebPDecodeRGBAInto(bytes, size, image.pixels.data(), image.pixels.size(), 4 * features.width) == nullptr) {
    throw InputError(name + ": is a damaged WebP picture; save it again");
  }
  if (hasAlpha != nullptr) *hasAlpha = features.has_alpha != 0;
  return image;
}

}  // namespace boxprobe
