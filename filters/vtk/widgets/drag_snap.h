// Where a dragged handle comes to lie while it snaps: on the wall under the pointer, on the wall it comes close to, or
// on a grid. Plain mathematics over rays.
#pragma once

#include <glm/vec3.hpp>

#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {

class SurfaceRays;

struct SnapSettings {
  double catchPixels = 14.0;      ///< a wall catches a face that is so near
  double largestStep = 0.1;       ///< of the grid, scene units
  double turnStepDegrees = 15.0;  ///< of rings
};

enum class SnapTarget { None, Pointed, Opposite, Grid };

class DragSnap {
 public:
  /// `surfaces` may be null: the grid alone. `metresPerPixel` at the handle: it sets how near a wall catches, and
  /// makes the grid's steps as coarse as a hand is.
  DragSnap(const SurfaceRays* surfaces, const Ray& pointer, double metresPerPixel, const SnapSettings& settings = {});

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
  double turnStepDegrees() const { return turnStepDegrees_; }

 private:
  const SurfaceRays* surfaces_;
  Ray pointer_;
  double reach_, step_, turnStepDegrees_;
  SnapTarget target_ = SnapTarget::None;
};

}  // namespace boxprobe
