// shaders/shared/lamp.glsl, lamp_lobe.glsl and lattice.glsl as C++: light of lamps that are flat polygons, and diffuse
// light from the lattice of a probe. One source for the picture and for what explains and judges it; the definitions
// are in lamp_math.cpp. Knows no scene: filters/core/geometry/scene_lamps finds the lamps,
// filters/math/cube/diffuse_lattice derives the lattice.
#pragma once

#include <array>

#include "filters/math/shared/shared_math.h"

namespace boxprobe {

struct LampPolygon;

}  // namespace boxprobe

namespace boxprobe::shading {

#define LAMP_SLOT const LampPolygon*
#include "shaders/shared/lamp_types.glsl"
#undef LAMP_SLOT
/// A lattice's texels as the mathematics sees them: what `fetchLattice` is on this side.
class LatticeSampler {
 public:
  virtual ~LatticeSampler() = default;
  /// Texel `part`, 0 to 6, or 9 if the way between some nodes is cut, of a node; linear between nodes. `place`: number
  /// of the node along each axis, within them.
  virtual glm::vec4 fetchLattice(const glm::vec3& place, int part) const = 0;
};

#define LATTICE_SLOT const LatticeSampler*
#include "shaders/shared/lattice_types.glsl"
#undef LATTICE_SLOT

}  // namespace boxprobe::shading

namespace boxprobe {

/// A lamp: convex and flat, its corners counterclockwise as its shining side is seen, in the frame of the positions
/// that it lights.
struct LampPolygon {
  std::array<glm::vec3, shading::kLampCorners> corners{};
  int count = 0;  ///< of the corners, at least 3
  bool bothSides = false;
};

}  // namespace boxprobe

namespace boxprobe::shading {

/// Mean of the corners.
vec3 lampMiddle(const LampPolygon* lamp);
/// Its plane: normal and distance, such that heights above it count from 1 on (lamp_plane.glsl).
vec4 lampPlane(const LampPolygon* lamp);

/// Irradiance over pi of a surface at `position` with the unit normal `normal`, of a lamp of radiance 1: 0 to 1.
float lampDiffuse(const LampPolygon* lamp, vec3 position, vec3 normal);

/// Share, 0 to 1, of lamps in a reflection of that roughness that is drawn from their shapes and not looked up in a
/// map.
float lampsByShape(float roughness);
/// Colour, of mean 1, of lamps that light so; where they do not, that of `first`.
vec3 lampColor(vec3 light, vec3 first);

LampLobe lampLobe(vec3 normal, vec3 view, float roughness);
/// What a surface with that lobe reflects of a lamp of radiance 1: F0 times x plus F90 times y.
vec2 lampGlossy(const LampPolygon* lamp, vec3 position, LampLobe lobe);

vec3 latticePlace(LatticeShape lattice, vec3 position);
/// Share of the next of two nodes at `t` of the way to it, where a surface that begins and ends at those parts of the
/// way, times `cut`, cuts so much of it.
float latticeStep(float t, float lean, float cut, float begins, float ends);
/// The place, in numbers of nodes, where the light of a surface at `place` is looked up, if ways between nodes are cut.
vec3 latticeSeen(LatticeShape lattice, vec3 place, vec3 facing);
/// Irradiance over pi; `position` and the direction that the surface faces in the probe's frame, that direction again
/// (the unit normal `n`) in the world's axes.
vec3 latticeIrradiance(LatticeShape lattice, vec3 position, vec3 facing, vec3 n);
/// Weight of the nodes around `position`, probe frame, seen from there or not, that do not have their light from
/// neighbours.
float latticeKnown(LatticeShape lattice, vec3 position);

}  // namespace boxprobe::shading
