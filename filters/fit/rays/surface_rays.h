// The question that fitting asks of a place: what does a ray meet first, and how does that reflect? Answered from a
// scene's triangles or from the distances that a probe captured. Called by the rest of filters/fit.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

struct SurfaceHit {
  double distance = 0.0;        ///< scene units
  bool back = false;            ///< the side was met from which the triangle's corners run clockwise
  glm::dvec3 normalWorld{0.0};  ///< unit, on the side that was met
  double roughness = 0.0;       ///< perceptual; 0 where it is not known
  double reflectance = 0.04;    ///< share of light reflected straight on, mean of the colours
  glm::vec3 albedo{0.0f};       ///< light scattered all over, a metal's reflection included; 0 where it is not known
};

class SurfaceRays {
 public:
  virtual ~SurfaceRays() = default;
  /// The first surface from `origin` along `direction` (unit), world. Nothing: the sky.
  virtual std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const = 0;
  /// Bounds of everything, world; a box of size 0 if there is nothing.
  virtual const Box& bounds() const = 0;
};

/// `count` directions spread evenly over the sphere (a spherical Fibonacci lattice), turned by `turn`, 0 to 1.
std::vector<glm::dvec3> evenDirections(int count, double turn = 0.0);

/// Unit direction of a uniform point of the unit square, uniform over the sphere.
glm::dvec3 sphereDirection(double u, double v);

/// Van der Corput's sequence in a prime base, in [0, 1): even at any length, and with other bases in any dimension.
double evenlySpread(int index, int base);

}  // namespace boxprobe
