// Where a dragged handle comes to lie while Ctrl is held: on the wall under the pointer, on the wall it comes close to,
// or on a grid. Called by the drags; plain mathematics over rays.
#pragma once

#include <glm/vec3.hpp>

#include "app/gui/handles/view_ray.h"
#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

enum class SnapTarget { None, Pointed, Opposite, Grid };

class DragSnap {
 public:
  /// `surfaces` may be null: the grid alone. `metresPerPixel` at the handle: it sets how near a wall catches, and
  /// makes the grid's steps as coarse as a hand is, at most 0.1 units.
  DragSnap(const SurfaceRays* surfaces, const Ray& pointer, double metresPerPixel);

  /// For a face at `point + offset axis` (axis of unit length): the offset it snaps to. A wall that faces along the
  /// axis and lies under the pointer comes first, then the wall that a ray from `inside` along the axis meets, if it is
  /// near, then the grid.
  double face(const glm::dvec3& point, const glm::dvec3& axis, double offset, const glm::dvec3& inside);
  /// The same without walls.
  double grid(const glm::dvec3& point, const glm::dvec3& axis, double offset);
  /// Every coordinate on the grid.
  glm::dvec3 grid(const glm::dvec3& point);

  SnapTarget target() const { return target_; }  ///< of the last answer
  double gridStep() const { return step_; }      ///< scene units

 private:
  const SurfaceRays* surfaces_;
  Ray pointer_;
  double reach_, step_;
  SnapTarget target_ = SnapTarget::None;
};

}  // namespace boxprobe
