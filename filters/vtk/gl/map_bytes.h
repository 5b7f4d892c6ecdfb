// GPU memory of probes' maps, computed before anything is allocated, because drivers react to a shortage with a crash,
// a black picture or minutes of swapping.
#pragma once

#include <cstddef>
#include <string>

namespace boxprobe {

/// For one probe: the filtered chain (RGBA16F) and, except for pictures, distances (R32F). `faceSize` in texels.
std::size_t probeMapsBytes(int faceSize, bool distances);
/// Additional memory while it is captured: the capture's own mip chain.
std::size_t captureScratchBytes(int faceSize);

/// "1.5 GB", "12 MB".
std::string memoryText(std::size_t bytes);

}  // namespace boxprobe
