// How much memory the maps of probes take on the graphics side, and how much there is: known before anything is
// allocated, because drivers answer too much with a crash, a black picture or minutes of swapping. Called by the probe
// set; knows sizes, no scenes.
#pragma once

#include <cstddef>
#include <string>

namespace boxprobe {

/// Of one probe: the filtered chain (RGBA16F) and, unless it is a picture's, distances (R32F).
std::size_t probeMapsBytes(int faceSize, bool distances);
/// While one is made, besides itself: the capture's own mip chain.
std::size_t captureScratchBytes(int faceSize);

/// What may be used: the environment variable BOXPROBE_TEXTURE_MEMORY, in MB; else what the driver says it has in all
/// (NVX_gpu_memory_info) or left (ATI_meminfo); else half of the machine's memory, which is where software drivers keep
/// textures. The context must be current.
std::size_t textureMemoryLimit();

/// "1.5 GB", "12 MB".
std::string memoryText(std::size_t bytes);

}  // namespace boxprobe
