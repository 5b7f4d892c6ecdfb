// What polygon lamps do to a surface, by adaptive quadrature over the polygon in long double, written from the
// formulas' sources and sharing nothing with shaders/shared/lamp.glsl; and lamps made by chance to judge it with.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "filters/math/shared/lamp_math.h"

namespace boxprobe::test {

using LongVec = glm::vec<3, long double>;

/// A lamp, seen from the surface at the origin.
struct LampCase {
  std::vector<LongVec> corners;  ///< flat, convex, counterclockwise as the origin sees them
  LongVec normal{0.0L};          ///< of the surface, unit
  LongVec view{0.0L};            ///< unit
  LampPolygon polygon() const;
};

/// Irradiance over pi of a lamp of radiance 1, seen from either side.
long double trueFormFactor(const std::vector<LongVec>& corners, const LongVec& normal);

/// What GGX with height-correlated masking and Schlick's reflectance (glTF 2.0, appendix B) reflects of it: F0 times x
/// plus F90 times y. alpha = roughness squared.
glm::dvec2 trueGlossy(const LampCase& lamp, double roughness);

/// A lamp of 0.2 to 1.5 m in a room, in the ceiling or in a wall, half of them where the floor under the origin mirrors
/// them; some reach below the floor. The floor is seen under `elevation` radians and turned at random.
LampCase randomFloorLamp(std::mt19937& random, double elevation);

/// A convex polygon of 3 to 8 corners anywhere, its size `size` and its distance from the origin about 1: beyond the
/// horizon of the surface, cut by it, or above.
LampCase randomPolygon(std::mt19937& random, double size);

}  // namespace boxprobe::test
