// Samples textures as OpenGL does at full resolution: bilinear, wrapped, sRGB decoded before interpolation. No mip
// levels: a reference takes as many rays as it needs.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// White without a picture. `coordinates` as in the mesh, of the set that `use` names, before its transform.
glm::vec4 sampleTexture(const TextureUse& use, const glm::vec2& coordinates, bool srgb);

}  // namespace boxprobe
