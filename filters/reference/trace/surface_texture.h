// Pictures on surfaces, looked up as OpenGL does at full resolution: bilinear, wrapped, sRGB decoded before it is
// interpolated. No mip levels: a reference takes as many rays as it needs instead.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// White where there is no picture. `coordinates` as in the mesh, of the set the use names, before its transform.
glm::vec4 sampleTexture(const TextureUse& use, const glm::vec2& coordinates, bool srgb);

}  // namespace boxprobe
