// How much memory the maps of probes take on the graphics side: known before anything is allocated, because drivers
// answer too much with a crash, a black picture or minutes of swapping. Arithmetic; knows sizes, no scenes and no
// OpenGL.
#pragma once

#include <cstddef>
#include <string>

namespace boxprobe {

/// Of one probe: the filtered chain (RGBA16F) and, unless it is a picture's, distances (R32F). `faceSize` in texels.
std::size_t probeMapsBytes(int faceSize, bool distances);
/// While one is made, besides itself: the capture's own mip chain.
std::size_t captureScratchBytes(int faceSize);

/// "1.5 GB", "12 MB".
std::string memoryText(std::size_t bytes);

}  // namespace boxprobe
