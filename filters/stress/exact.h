// The formulas of projection and lookup in long double, straight from their definitions: what single precision is
// measured against. Deliberately shares nothing with shaders/. Inputs are floats taken as exact. Called by
// stress_subjects; knows no techniques by name.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace boxprobe::stress::exact {

using Real = long double;
using Vec = std::array<Real, 3>;

Vec vec(const glm::vec3& v);
Real dot(const Vec& a, const Vec& b);
Real length(const Vec& a);
/// Largest difference of a component; NaN if one is NaN.
Real farthest(const glm::vec3& a, const Vec& b);

/// Distance to the exit plane of one axis; a start beyond it gives 0, a ray that never gets there 3e38 (as far as a
/// float reaches).
Real slabFactor(Real position, Real direction, Real low, Real high);

struct BoxExit {
  Vec factors;
  Real distance;
  Vec hit;  ///< on the box
};
BoxExit boxExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high);

/// Exit from the box with its edges rounded by `bevel`: where a point has left all that lies within r of the inner box,
/// r no more than lets the start be inside (the sum of the two smallest distances from a face) and than half the
/// shortest side. The set is convex, so bisection finds the exit. Of a start inside the sharp box; `exit`: the sharp
/// box's.
Real roundedBoxExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high, Real bevel, Real exit);

struct SphereExit {
  Real radius;
  Real distance;   ///< 0 where the sphere lies behind; the closest approach where the ray misses it
  Real steepness;  ///< cosine of the angle at which the ray meets the sphere: 0 where it only touches
  Vec hit;
};
/// Of the sphere around the box.
SphereExit sphereExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high);

/// How a solid angle at P scales to C: (t / |d|)² cos_C / cos_P for the wall that is hit, walls that are hit nearly as
/// soon blended in by (t / t_i)⁴; `hit` relative to C, `t` its distance from P along the unit `ray`. With the bounds
/// the definition states: |d| no less than 1e-4 t, cos_P no less than 1e-3, cos_C no more than 1e6.
Real solidAngleScaleBox(const Vec& hit, Real t, const Vec& factors, const Vec& ray, const Vec& low, const Vec& high);
Real solidAngleScaleSphere(const Vec& hit, Real t, const Vec& ray, const Vec& low, const Vec& high);

/// GGX: D and G1, by their textbook forms.
Real ggxDistribution(const Vec& halfVector, Real alpha);
Real ggxMasking(Real cosine, Real alpha);

/// Product of smoothsteps of distance inside / blend distance over six faces.
Real influence(const Vec& position, const Vec& low, const Vec& high, Real rate);

/// Levels: curve by the order of parameter `curve`, roughness as it is.
Real levelForRoughness(int curve, Real roughness, Real maxLevel);
Real levelApproximate(int curve, Real roughness, Real maxLevel, Real distance, Real hardeningLength);
Real levelHdrp(int curve, Real roughness, Real maxLevel, Real distance, Real distanceFromOrigin);
Real levelGodot(int curve, Real roughness, Real maxLevel, Real distance, Real hardeningLength, Real facing, Real power);

}  // namespace boxprobe::stress::exact
