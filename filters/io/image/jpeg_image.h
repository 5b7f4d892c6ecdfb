// JPEG through libjpeg-turbo, which takes less than a third of the time of stb's decoder. Called by image_file.cpp.
#pragma once

#include <cstddef>
#include <string>

namespace boxprobe {

/// Grey or three colours? Others (CMYK) this does not decode.
bool isJpeg(const unsigned char* bytes, std::size_t size, int channels);

/// Into `rgba`, which has room for the width and height that the header states; alpha is 255. Empty, or what is wrong:
/// a picture that ends early or has codes that are none is damaged.
std::string decodeJpeg(const unsigned char* bytes, std::size_t size, int width, int height, unsigned char* rgba);

}  // namespace boxprobe
