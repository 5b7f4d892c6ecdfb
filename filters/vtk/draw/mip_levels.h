// Mip levels of a picture, made here where a software renderer would first compile programs to make them. Called by
// SurfaceTexture; knows no OpenGL.
#pragma once

#include <cstdint>
#include <vector>

namespace boxprobe {

struct MipLevel {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< RGBA, rows as those of the picture
};

/// The next level of `width` x `height` RGBA bytes: half as large each way, rounded down, at least 1. Each texel is the
/// linear interpolation of the level above at its middle, the mean of four where sizes are even. `srgb`: of the light
/// that the bytes stand for, alpha apart.
MipLevel nextMipLevel(int width, int height, const std::vector<std::uint8_t>& pixels, bool srgb);

}  // namespace boxprobe
