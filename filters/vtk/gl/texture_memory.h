// How much memory there is for the maps of probes on the graphics side (map_bytes.h says how much they take). Called by
// the probe set.
#pragma once

#include <cstddef>

namespace boxprobe {

/// Bytes that may be used: the environment variable BOXPROBE_TEXTURE_MEMORY, in MB; else what the driver of a graphics
/// card says it has in all (NVX_gpu_memory_info) or left (ATI_meminfo); else half of the machine's memory, which is
/// where software drivers keep textures. The context must be current.
std::size_t textureMemoryLimit();

}  // namespace boxprobe
