// shaders/shared/planar_mirror.glsl as C++: what a planar mirror shows of moving objects.
#pragma once

#include <array>
#include <vector>

#include "filters/math/shared/shared_math.h"

namespace boxprobe {

/// The picture of a mirror, read back: levels of premultiplied colour with coverage, and of height times coverage.
struct MirrorTexels {
  struct Level {
    int width = 0, height = 0;
    std::vector<glm::vec4> color, heights;  ///< rows from the bottom
  };
  std::vector<Level> levels;
};

}  // namespace boxprobe

namespace boxprobe::shading {

#define MIRROR_PICTURE const MirrorTexels*
#include "shaders/shared/mirror_types.glsl"
#undef MIRROR_PICTURE

vec2 mirrorPlace(MirrorLook look, vec3 position);
bool mirrorReaches(MirrorLook look, vec3 position, vec3 reflection, float alpha);
float mirrorHeight(MirrorLook look, vec3 position, vec3 reflection, float solidAngle, int steps);
int mirrorFetches(MirrorLook look, vec3 position, vec3 normal, vec3 view, float roughness);
float mirrorLevel(MirrorLook look, vec3 met, float distance, float solidAngle);
vec4 mirroredLight(MirrorLook look, vec3 position, vec3 normal, vec3 view, float roughness);

}  // namespace boxprobe::shading
