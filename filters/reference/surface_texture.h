// Pictures on surfaces, looked up as OpenGL does at full resolution: bilinear, wrapped, sRGB decoded before it is
// interpolated. No mip levels: a reference takes as many rays as it needs instead.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "filters/core/model.h"

namespace boxprobe {

/// White where there is no picture. `uv` as in Mesh. VTK 9.1 has one wrap mode for both axes, that of S.
glm::vec4 sampleTexture(const TextureUse& use, const glm::vec2& uv, bool srgb);

}  // namespace boxprobe
