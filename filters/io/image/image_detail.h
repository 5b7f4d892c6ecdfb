// What the readers of pictures share inside this folder: limits, and decoding from memory for models.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe {

constexpr long long kLargestImageSide = 32768;
/// 2 GiB as float RGBA, a sky of 16384 x 8192: a damaged header must not make the program ask for more.
constexpr long long kMostPixels = 1LL << 27;
/// stb counts bytes in an int.
constexpr std::size_t kLargestEncodedImage = 0x7fffffff;

/// Throws InputError naming the picture and the figure that is too large, before anything is allocated for it.
void checkImageSize(const std::string& name, long long width, long long height);

/// Throws InputError if `bytes` of file cannot hold this many pixels at `mostPixelsAByte`: decoders ask for the memory
/// first, and some fill up silently what a file lacks.
void checkEncodedSize(const std::string& name, long long width, long long height, std::size_t bytes,
                      long long mostPixelsAByte);

/// Throws WorkError unless the array holds width * height RGBA texels: a mistake in the program, caught before a file
/// is.
void checkPixelCount(const std::string& path, int width, int height, std::size_t values);

/// PNG, JPEG or WebP from memory; `name` stands for it in messages and in the result. `*hasAlpha` when given: whether
/// the file has an alpha channel.
ImageRgba8 decodeImage8(const unsigned char* bytes, std::size_t size, const std::string& name,
                        bool* hasAlpha = nullptr);

/// Any scan-line or tiled RGBA, RGB or Y file, half or float; values as stored, non-finite ones included.
ImageRgbaF loadExr(const std::string& path);

}  // namespace boxprobe
