// RGBM: linear radiance in four bytes, for engines and textures without floats. A texel stands for
//
//     rgb = x * M^y * colour           (colour and M from 0 to 1, 255 steps each)
//
// with the decode instruction (x, y): x is the largest value, y bends M so that dark values get finer steps. The colour
// is the bytes' own value or, as engines store it, sRGB that the sampler decodes; M is always linear. Unity's
// instruction for linear colour is (34.493242, 2.2) over sRGB bytes: its gamma-space range of 5, to the power of 2.2.
// With M = 255 the same formula is double LDR, 2^2.2 over sRGB bytes. RGBM has no alpha, so coverage is lost.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace boxprobe {

struct RgbmInstruction {
  float x = 5.0f;
  float y = 1.0f;
  bool srgb = false;  ///< are the colour's bytes sRGB?
};

using RgbmTexel = std::array<std::uint8_t, 4>;  ///< r, g, b, M

/// x * M^y: the radiance of a colour of 1.
float rgbmScale(std::uint8_t m, const RgbmInstruction& instruction);

/// Linear radiance of a texel.
glm::vec3 decodeRgbm(const RgbmTexel& texel, const RgbmInstruction& instruction);

}  // namespace boxprobe
