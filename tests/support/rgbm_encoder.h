// The other way of filters/math/cube/rgbm.h: radiance as RGBM, the best that eight bits can, and how far that is off.
// Called by tests that want such pictures.
#pragma once

#include <cstddef>

#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/rgbm.h"

namespace boxprobe {

/// The texel that decodes nearest: of the multipliers that hold the largest component the best, not merely the smallest
/// one. A colour with a component above x is scaled down to it, its hue kept; negative components and NaN count as 0.
RgbmTexel encodeRgbm(const glm::vec3& radiance, const RgbmInstruction& instruction);

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
