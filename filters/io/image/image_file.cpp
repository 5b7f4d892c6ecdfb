// Chooses a decoder: Radiance HDR goes through radiance_reader.cpp, PNG through png_image.cpp, JPEG through
// jpeg_image.cpp, WebP through webp_image.cpp, OpenEXR through exr_file.cpp, what else there is (BMP, TGA) through stb.
#include "filters/io/image/image_file.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <new>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/read_file.h"
#include "filters/io/image/image_detail.h"
#include "filters/io/image/jpeg_image.h"
#include "filters/io/image/png_image.h"
#include "filters/io/image/radiance_reader.h"
#include "filters/io/image/webp_image.h"

namespace boxprobe {

namespace {

struct StbFree {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

const unsigned char* asBytes(const std::string& text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

// The decoder's reason may quote the file: the name of a chunk is any four bytes.
InputError damaged(const std::string& name, const std::string& why = stbi_failure_reason()) {
  if (why == "outofmem") throw std::bad_alloc();
  return InputError(oneLine(name + ": is damaged (" + why + "); save it again"));
}

void appendBytes(void* target, void* data, int size) {
  static_cast<std::string*>(target)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

/// Big-endian.
long long number32(const unsigned char* bytes) {
  long long number = 0;
  for (int i = 0; i < 4; ++i) number = number * 256 + bytes[i];
  return number;
}

}  // namespace

void checkImageSize(const std::string& name, long long width, long long height) {
  if (width <= 0 || height <= 0) throw InputError(name + ": has no pixels; save it again");
  if (width > limits::kPictureSide || height > limits::kPictureSide) {
    throw InputError(name + ": is " + std::to_string(width) + " x " + std::to_string(height) + " pixels; at most " +
                     std::to_string(limits::kPictureSide) + " a side are read");
  }
  if (width * height > limits::kPicturePixels) {
    throw InputError(name + ": is " + std::to_string(width) + " x " + std::to_string(height) + " pixels; at most " +
                     std::to_string(limits::kPicturePixels) + " in all are read");
  }
}

void checkEncodedSize(const std::string& name, long long width, long long height, std::size_t bytes,
                      long long mostPixelsAByte) {
  if (width * height / mostPixelsAByte <= static_cast<long long>(bytes)) return;
  throw InputError(name + ": is damaged: " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels are promised in " + std::to_string(bytes) + " bytes; save it again");
}

ImageRgba8 decodeImage8(const unsigned char* bytes, std::size_t size, const std::string& name, bool* hasAlpha) {
  constexpr unsigned char kKtx2[] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb};
  if (size >= sizeof(kKtx2) && std::equal(std::begin(kKtx2), std::end(kKtx2), bytes)) {
    throw InputError(name +
                     ": is a KTX2 picture, which is not read; save it as PNG (gltf-transform ktxdecompress IN OUT)");
  }
  if (isWebp(bytes, size)) return decodeWebp(bytes, size, name, hasAlpha);
  ImageRgba8 image;
  image.name = name;
  int channels = 0;
  const int length = static_cast<int>(std::min(size, limits::kPictureBytes));
  if (size == 0 || size > limits::kPictureBytes ||
      stbi_info_from_memory(bytes, length, &image.width, &image.height, &channels) == 0) {
    constexpr std::size_t kPngHeader = 24;  // signature, the chunk's length and name, width, height
    if (isPng(bytes, size) && size >= kPngHeader) checkImageSize(name, number32(bytes + 16), number32(bytes + 20));
    throw InputError(name + ": is not a PNG, JPEG or WebP picture; save it as one of these");
  }
  checkImageSize(name, image.width, image.height);
  // PNG: deflate's ratio of 1032 times 8 pixels per byte at the lowest depth. JPEG: one bit for a block of 64 pixels.
  const bool png = isPng(bytes, size);
  constexpr long long kPngPixelsAByte = 8 * 1032, kJpegPixelsAByte = 8 * 64;
  checkEncodedSize(name, image.width, image.height, size, png ? kPngPixelsAByte : kJpegPixelsAByte);
  if (png || isJpeg(bytes, size)) {
    image.pixels.resize(std::size_t(4) * image.width * image.height);
    bool alpha = false;
    const std::string why = png ? decodePng(bytes, size, image.width, image.height, image.pixels.data(), alpha)
                                : decodeJpeg(bytes, size, image.width, image.height, image.pixels.data());
    channels = alpha ? 4 : 3;
    if (!why.empty()) throw damaged(name, why);
  } else {
    const std::unique_ptr<unsigned char, StbFree> pixels(
        stbi_load_from_memory(bytes, length, &image.width, &image.height, &channels, 4));
    if (!pixels) throw damaged(name);
    image.pixels.assign(pixels.get(), pixels.get() + std::size_t(4) * image.width * image.height);
  }
  if (hasAlpha != nullptr) *hasAlpha = channels == 2 || channels == 4;
  return image;
}

ImageRgba8 loadImage8(const std::string& path, bool* hasAlpha) {
  const std::string bytes = readWholeFile(path);
  return decodeImage8(asBytes(bytes), bytes.size(), path, hasAlpha);
}

std::string encodePng(const std::string& path, const ImageRgba8& image) {
  checkPixelCount(path, image.width, image.height, image.pixels.size());
  // Through memory: the encoder's own file output does not notice a full disk.
  std::string encoded = encodedPng(image.pixels.data(), image.width, image.height);
  if (encoded.empty()) {
    throw WorkError(path + ": the picture could not be encoded; is there memory left?");
  }
  return encoded;
}

void savePng(const std::string& path, const ImageRgba8& image) {
  writeTextAtomically(path, encodePng(path, image));
}

void saveRadiance(const std::string& path, const ImageRgbaF& image) {
  checkPixelCount(path, image.width, image.height, image.pixels.size());
  std::string encoded;
  if (stbi_write_hdr_to_func(appendBytes, &encoded, image.width, image.height, 4, image.pixels.data()) == 0) {
    throw WorkError(path + ": the picture could not be encoded; is there memory left?");
  }
  writeTextAtomically(path, encoded);
}

void checkPixelCount(const std::string& path, int width, int height, std::size_t values) {
  if (width <= 0 || height <= 0 || values != std::size_t(4) * width * height) {
    throw WorkError(path + ": not written: " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels do not match " + std::to_string(values) + " values");
  }
}

ImageRgbaF loadHdrImage(const std::string& path, std::size_t* notFinite) {
  const std::string extension = lowerExtension(path);
  ImageRgbaF image;
  if (extension == ".exr") {
    image = loadExr(path);
  } else if (extension == ".hdr") {
    image = decodeRadiance(readWholeFile(path), path).image;
  } else {
    throw InputError(path + ": has an extension that is not read; use .exr or .hdr");
  }
  std::size_t count = 0;
  for (std::size_t texel = 0; texel < image.pixels.size(); texel += 4) {
    float* rgba = image.pixels.data() + texel;
    if (std::all_of(rgba, rgba + 4, [](float v) { return std::isfinite(v); })) continue;
    ++count;
    std::replace_if(
        rgba, rgba + 4, [](float v) { return !std::isfinite(v); }, 0.0f);
  }
  if (notFinite != nullptr) *notFinite = count;
  return image;
}

}  // namespace boxprobe
