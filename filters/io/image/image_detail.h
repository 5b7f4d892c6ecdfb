// Shared by the readers of pictures in this folder: limits, and decoding from memory.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Throws InputError with the picture and the excessive figure, before memory is allocated.
void checkImageSize(const std::string& name, long long width, long long height);

/// Throws InputError if `bytes` of file cannot hold this many pixels at `mostPixelsAByte`: decoders allocate first, and
/// some silently pad truncated files.
void checkEncodedSize(const std::string& name, long long width, long long height, std::size_t bytes,
                      long long mostPixelsAByte);

/// Throws WorkError unless the array holds width * height RGBA texels: catches a programming error before a file is
/// written.
void checkPixelCount(const std::string& path, int width, int height, std::size_t values);

/// Decodes PNG, JPEG or WebP from memory; `name` is used in messages and stored in the result. `*hasAlpha` if given:
/// does the file have an alpha channel?
ImageRgba8 decodeImage8(const unsigned char* bytes, std::size_t size, const std::string& name,
                        bool* hasAlpha = nullptr);

/// Any scan-line or tiled RGBA, RGB or Y file, half or float, as linear Rec. 709; the data window, non-finite values
/// included.
ImageRgbaF loadExr(const std::string& path);

}  // namespace boxprobe
