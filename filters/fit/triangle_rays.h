// Rays against the triangles of a scene's models: how far the first surface is and whether its front was met. Positions
// and winding alone, no materials: what fitting asks. Called by the rest of this room; knows no VTK and no files.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

struct SurfaceHit {
  double distance = 0.0;        ///< scene units
  bool back = false;            ///< the side was met from which the triangle's corners run clockwise
  glm::dvec3 normalWorld{0.0};  ///< unit, on the side that was met
};

/// Every triangle that is drawn and hides what is behind it, where the scene puts it. Left out: invisible objects,
/// glass (transmission) and what blends, through which light passes, and a dome with a painted sky about everything
/// else.
class TriangleRays {
 public:
  using Models = std::vector<std::shared_ptr<const Model>>;

  /// `models` in the order of scene.models. Throws WorkError where the ray tracer cannot take them.
  TriangleRays(const Scene& scene, const Models& models);
  ~TriangleRays();
  TriangleRays(const TriangleRays&) = delete;
  TriangleRays& operator=(const TriangleRays&) = delete;

  bool empty() const { return triangles_ == 0; }
  /// Bounds of all triangles, world; a box of size 0 if there is none.
  const Box& bounds() const { return bounds_; }
  /// Bounds without the far hundredth of the surfaces on every side, each counted by the root of its area: a lone thing
  /// far away, or a large plain under everything, does not stretch it.
  const Box& core() const { return core_; }

  /// The first surface from `origin` along `direction` (unit), world. Nothing: the sky.
  std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const;

 private:
  struct Structure;
  std::unique_ptr<Structure> structure_;
  glm::dvec3 anchor_{0.0};  ///< middle of everything: keeps the digits of a scene far from the origin
  Box bounds_, core_;
  std::size_t triangles_ = 0;
};

/// `count` directions spread evenly over the sphere (a spherical Fibonacci lattice), turned by `turn`, 0 to 1.
std::vector<glm::dvec3> evenDirections(int count, double turn = 0.0);

}  // namespace boxprobe
