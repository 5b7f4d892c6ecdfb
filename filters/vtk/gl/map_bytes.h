// GPU memory of probes' maps, computed before anything is allocated, because drivers react to a shortage with a crash,
// a black picture or minutes of swapping.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// For one probe: the filtered chain (RGBA16F) and, except for pictures, distances (R32F). `faceSize` in texels.
std::size_t probeMapsBytes(int faceSize, bool distances);
/// Additional memory while it is captured: the capture's own mip chain.
std::size_t captureScratchBytes(int faceSize);

/// Main memory of a probe's lattice of diffuse light (filters/math/cube/diffuse_lattice.h) with as many nodes as one
/// that is traced may have.
std::size_t latticeBytes(const Probe& probe);
/// Texture memory for the lattices of so many probes: one texture, whose tiles are doubled until all fit.
std::size_t latticeAtlasBytes(std::size_t lattices);

/// "1.5 GB", "12 MB".
std::string memoryText(std::size_t bytes);

}  // namespace boxprobe
