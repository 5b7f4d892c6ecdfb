// The translation unit that compiles shaders/shared/lamp.glsl, lamp_lobe.glsl and lattice.glsl as C++.
#include "filters/math/shared/lamp_math.h"

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

static int lampCornerCount(const LampPolygon* lamp) {
  return lamp->count;
}

static vec3 lampCorner(const LampPolygon* lamp, int i) {
  return lamp->corners[static_cast<std::size_t>(i)];
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
