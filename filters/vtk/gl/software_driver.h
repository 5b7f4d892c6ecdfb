// Whether the current OpenGL driver draws with the CPU, and what is left out then. Asked by whoever sets up textures,
// the window and the benchmark. Needs a current context; knows nothing of scenes.
#pragma once

#include <string>

namespace boxprobe {

/// What OpenGL calls the current context's renderer, as in "llvmpipe (LLVM 15.0.6, 256 bits)"; empty without a context.
std::string rendererName();

/// True for Mesa's llvmpipe, softpipe, SWR and swrast and for other drivers that name themselves software renderers;
/// false without a current context.
bool drawsOnCpu();

/// The largest number of samples along a texel footprint's longer axis, for GL_TEXTURE_MAX_ANISOTROPY_EXT: 8 where
/// a graphics card draws, 1 (none) on software renderers and without a context. llvmpipe's anisotropic sampling of
/// a degenerate footprint, as in a triangle seen edge-on, was measured to take minutes for one frame.
float textureAnisotropy();

}  // namespace boxprobe
