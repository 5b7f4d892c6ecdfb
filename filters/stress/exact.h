// The formulas of projection and lookup in long double, straight from their definitions: the reference for single
// precision. Deliberately shares nothing with shaders/. Inputs are floats taken as exact.
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

/// Distance to the exit plane of one axis: 0 for a start beyond it, 3e38 (float's maximum) for a ray that never reaches
/// it.
Real slabFactor(Real position, Real direction, Real low, Real high);

struct BoxExit {
  Vec factors;
  Real distance;
  Vec hit;  ///< on the box
};
BoxExit boxExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high);

/// Exit from the box with its edges rounded by `bevel`: where a point leaves the set of points within r of the inner
/// box. r is bounded so that the start is inside (the sum of the two smallest distances from a face), and by half the
/// shortest side. The set is convex, so bisection finds the exit. The start must be inside the sharp box; `exit`: the
/// sharp box's.
Real roundedBoxExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high, Real bevel, Real exit);

struct SphereExit {
  Real radius;
  Real distance;   ///< 0 if the sphere is behind; the closest approach if the ray misses it
  Real steepness;  ///< cosine of the angle between ray and sphere normal: 0 for a tangent
  Vec hit;
};
/// Of the sphere around the box.
SphereExit sphereExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high);

/// The ratio of solid angles at P and C: (t / |d|)² cos_C / cos_P for the wall that is hit, with walls at similar
/// distances blended in by (t / t_i)⁴; `hit` relative to C, `t` its distance from P along the unit `ray`. Clamped as in
/// the definition: |d| >= 1e-4 t, cos_P >= 1e-3, cos_C <= 1e6.
Real solidAngleScaleBox(const Vec& hit, Real t, const Vec& factors, const Vec& ray, const Vec& low, const Vec& high);
Real solidAngleScaleSphere(const Vec& hit, Real t, const Vec& ray, const Vec& low, const Vec& high);

/// GGX: textbook forms of D and G1.
Real ggxDistribution(const Vec& halfVector, Real alpha);
Real ggxMasking(Real cosine, Real alpha);

/// The product over six faces of smoothsteps of (distance inside / blend distance).
Real influence(const Vec& position, const Vec& low, const Vec& high, Real rate);

/// Levels; `curve` is the index of parameter `curve`, roughness is perceptual.
Real levelForRoughness(int curve, Real roughness, Real maxLevel);
Real levelApproximate(int curve, Real roughness, Real maxLevel, Real distance, Real hardeningLength);
Real levelHdrp(int curve, Real roughness, Real maxLevel, Real distance, Real distanceFromOrigin);
Real levelGodot(int curve, Real roughness, Real maxLevel, Real distance, Real hardeningLength, Real facing, Real power);

}  // namespace boxprobe::stress::exact
