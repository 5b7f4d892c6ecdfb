// Finds the first surface along a ray, and how it reflects: from a scene's triangles, or from the distances that a
// probe captured.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

struct SurfaceHit {
  double distance = 0.0;        ///< scene units
  bool back = false;            ///< the ray met the side on which the triangle's corners run clockwise
  glm::dvec3 normalWorld{0.0};  ///< unit, on the side that was met
  double roughness = 0.0;       ///< perceptual; 0 if unknown
  double reflectance = 0.04;    ///< reflectance at normal incidence, mean of the colours
  glm::vec3 albedo{0.0f};       ///< including a metal's reflection; 0 if unknown
  glm::vec3 emitted{0.0f};      ///< radiance on the side that was met, mean over its textures; 0 if unknown
};

class SurfaceRays {
 public:
  virtual ~SurfaceRays() = default;
  /// The first surface from `origin` along `direction` (unit), world. Nothing if the ray reaches the sky.
  virtual std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const = 0;
  /// World bounds of everything; a box of size 0 if there is nothing.
  virtual const Box& bounds() const = 0;
};

/// `count` directions, evenly distributed over the sphere (a spherical Fibonacci lattice) and rotated by `turn`, 0 to
/// 1.
std::vector<glm::dvec3> fibonacciDirections(int count, double turn = 0.0);

/// Maps a uniform point of the unit square to a uniform direction.
glm::dvec3 sphereDirection(double u, double v);

}  // namespace boxprobe
