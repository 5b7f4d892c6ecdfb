// The GPU memory available for probes' maps (map_bytes.h computes what they need).
#pragma once

#include <cstddef>

namespace boxprobe {

/// In bytes: the environment variable BOXPROBE_TEXTURE_MEMORY, in MB; else what a graphics card's driver reports as
/// total (NVX_gpu_memory_info) or free (ATI_meminfo); else half of main memory, where software drivers keep textures.
/// The context must be current.
std::size_t textureMemoryLimit();

}  // namespace boxprobe
