// Does the current OpenGL driver render on the CPU, and what is disabled then? Needs a current context.
#pragma once

#include <string>

namespace boxprobe {

/// GL_RENDERER of the current context, as in "llvmpipe (LLVM 15.0.6, 256 bits)"; empty without a context.
std::string rendererName();

/// True for Mesa's llvmpipe, softpipe, SWR and swrast and other software renderers, by their names; false without a
/// current context.
bool drawsOnCpu();

/// The value for GL_TEXTURE_MAX_ANISOTROPY_EXT: 8 on graphics cards, 1 (off) on software renderers and without a
/// context. In llvmpipe, anisotropic sampling of a degenerate footprint, as in a triangle seen edge-on, took minutes
/// for one frame.
float textureAnisotropy();

}  // namespace boxprobe
