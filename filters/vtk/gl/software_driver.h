// Does the current OpenGL driver render on the CPU, and what is done or left out then? Needs a current context.
#pragma once

#include <string>

namespace boxprobe {

/// GL_RENDERER of the current context, as in "llvmpipe (LLVM 15.0.6, 256 bits)"; empty without a context.
std::string rendererName();

/// True for Mesa's llvmpipe, softpipe, SWR and swrast and other software renderers, by their names; false without a
/// current context.
bool drawsOnCpu();

/// Is what is done for speed to suit the CPU: flat pictures of cubemaps and mip levels drawn, and in the window no
/// multisampling? As drawsOnCpu() says, unless the environment variable BOXPROBE_RENDERER_TUNING is `cpu` or `gpu`.
/// Pictures that are written are the same either way to 1/255.
bool tunedForCpu();

/// May a mip level be drawn from the one above it in the same texture, as OpenGL allows? Softpipe and zink of Mesa 22.3
/// read the level above wrongly then.
bool drawsLevelFromLevel();

/// The value for GL_TEXTURE_MAX_ANISOTROPY_EXT: what the environment variable BOXPROBE_ANISOTROPY says (1 to 16), else
/// 8 on graphics cards, 1 (off) on software renderers and without a context. It changes pictures, so what measures
/// accuracy sets and names it. In llvmpipe, anisotropic sampling of a degenerate footprint, as in a triangle seen
/// edge-on, took minutes for one frame.
float textureAnisotropy();

}  // namespace boxprobe
