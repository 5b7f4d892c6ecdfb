// Cubemaps of half floats as engines load them: KTX2 and DDS, uncompressed, every level. In memory: the caller writes
// the bytes. Values come as they are to be sampled; axes and filtering are export_cube's.
#pragma once

#include <cstddef>
#include <string>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// What a half float does not hold.
struct HalfLoss {
  std::size_t texelsNotFinite = 0;  ///< NaN or infinite: written as 0
  std::size_t texelsAtLimit = 0;    ///< 65504, the largest half, or more: written as that
  bool any() const { return texelsNotFinite + texelsAtLimit > 0; }
};
/// Of level 0; filtered levels are means of it.
HalfLoss halfLoss(const CubeMap& cube);
/// Does a texel of level 0 cover less than all (alpha below 1)?
bool coversPartly(const CubeMap& cube);

/// KTX 2.0: VK_FORMAT_R16G16B16A16_SFLOAT, linear BT.709, faces +X -X +Y -Y +Z -Z, smallest level first. `writer` is
/// what KTXwriter says.
std::string encodeKtx2(const CubeMap& cube, const std::string& writer);

/// DDS with the DX10 header: DXGI_FORMAT_R16G16B16A16_FLOAT, each face followed by its levels.
std::string encodeDds(const CubeMap& cube);

}  // namespace boxprobe
