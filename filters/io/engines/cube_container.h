// Encodes half-float cubemaps in memory for engines: KTX2 and DDS, uncompressed, all levels. Axes and filtering are
// export_cube's task.
#pragma once

#include <cstddef>
#include <string>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// Values that half floats cannot hold.
struct HalfLoss {
  std::size_t texelsNotFinite = 0;  ///< NaN or infinite: written as 0
  std::size_t texelsAtLimit = 0;    ///< 65504, the largest half, or more: clamped
  bool any() const { return texelsNotFinite + texelsAtLimit > 0; }
};
/// Counts level 0 alone: filtered levels are means of it.
HalfLoss halfLoss(const CubeMap& cube);
/// Is any texel of level 0 partly covered (alpha below 1)?
bool coversPartly(const CubeMap& cube);

/// KTX 2.0: VK_FORMAT_R16G16B16A16_SFLOAT, linear BT.709, faces +X -X +Y -Y +Z -Z, smallest level first. `writer`: the
/// text of KTXwriter.
std::string encodeKtx2(const CubeMap& cube, const std::string& writer);

/// DDS with the DX10 header: DXGI_FORMAT_R16G16B16A16_FLOAT, each face followed by its levels.
std::string encodeDds(const CubeMap& cube);

}  // namespace boxprobe
