// RGBM: linear radiance in four bytes, for engines and textures without floats. A texel stands for
//
//     rgb = x * M^y * texel.rgb        (texel and M from 0 to 1, 255 steps each)
//
// with the decode instruction (x, y): x is the brightest value there is, y bends M so that dark values get finer steps.
// (x, y) = (5, 1) and (34.49, 2.2) are Unity's for gamma and linear colour. Called by exports and by `bake`'s report;
// alpha has no place in it: coverage is lost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

struct RgbmInstruction {
  float x = 5.0f;
  float y = 1.0f;
};

using RgbmTexel = std::array<std::uint8_t, 4>;  ///< r, g, b, M

/// The texel that decodes nearest: of the multipliers that hold the largest component the best, not merely the smallest
/// one. A colour with a component above x is scaled down to it, its hue kept; negative components and NaN count as 0.
RgbmTexel encodeRgbm(const glm::vec3& radiance, const RgbmInstruction& instruction);
glm::vec3 decodeRgbm(const RgbmTexel& texel, const RgbmInstruction& instruction);

/// How far encoding and decoding leads from half float. Relative errors are of a texel's worst component, over its
/// largest component, so that a dark component beside a bright one weighs as it is seen; clipped texels and black ones
/// are counted, not averaged.
struct RgbmError {
  std::size_t texels = 0;
  std::size_t clipped = 0;   ///< above x, or negative: 8 bits cannot hold it
  std::size_t vanished = 0;  ///< not black, and decoded as black
  double meanRelative = 0.0;
  double rmsRelative = 0.0;
  double percentile99Relative = 0.0;
  double worstRelative = 0.0;
  double halfWorstRelative = 0.0;  ///< of half float itself against float, the same texels: what to compare with
  double lostEnergy = 0.0;         ///< share of the summed radiance that clipping took
};

/// Of every level's texels of a cube.
RgbmError measureRgbm(const CubeMap& radiance, const RgbmInstruction& instruction);

}  // namespace boxprobe
