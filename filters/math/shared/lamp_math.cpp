// The translation unit that compiles shaders/shared/lamp.glsl, lamp_lobe.glsl and lattice.glsl as C++.
#include "filters/math/shared/lamp_math.h"

#include <algorithm>

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

#include "shaders/shared/lamp_plane.glsl"

static int lampCornerCount(const LampPolygon* lamp) {
  return lamp->count;
}

static vec3 lampCorner(const LampPolygon* lamp, int i) {
  return lamp->corners[static_cast<std::size_t>(i)];
}

vec3 lampMiddle(const LampPolygon* lamp) {
  vec3 sum(0.0f);
  for (int i = 0; i < lamp->count; ++i) sum += lampCorner(lamp, i);
  return sum / static_cast<float>(std::max(lamp->count, 1));
}

vec4 lampPlane(const LampPolygon* lamp) {
  return lampPlaneThrough(lamp->corners[0], lamp->corners[1], lamp->corners[2]);
}

static bool lampShinesBothSides(const LampPolygon* lamp) {
  return lamp->bothSides;
}

static vec4 fetchLattice(const LatticeSampler* lattice, vec3 place, int part) {
  return lattice->fetchLattice(place, part);
}

#define LAMP_SLOT const LampPolygon*
#include "shaders/shared/lamp.glsl"
#include "shaders/shared/lamp_fade.glsl"
#include "shaders/shared/lamp_lobe.glsl"  // after lamp.glsl, which it uses
#undef LAMP_SLOT
#include "shaders/shared/lattice.glsl"

}  // namespace boxprobe::shading
