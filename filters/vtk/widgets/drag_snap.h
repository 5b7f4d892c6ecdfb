// Snaps a dragged handle: to the wall under the pointer, to a nearby wall, or to a grid.
#pragma once

#include <glm/vec3.hpp>

#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {

class SurfaceRays;

struct SnapSettings {
  double catchPixels = 14.0;      ///< a wall attracts a face within this distance
  double largestStep = 0.1;       ///< maximum grid step, scene units
  double turnStepDegrees = 15.0;  ///< for rings
};

enum class SnapTarget { None, Pointed, Opposite, Grid };

class DragSnap {
 public:
  /// `surfaces` may be null: only the grid. `metresPerPixel` at the handle: determines the distance at which walls
  /// attract, and the grid step.
  DragSnap(const SurfaceRays* surfaces, const Ray& pointer, double metresPerPixel, const SnapSettings& settings = {});

  /// The offset to which a face at `point + offset axis` snaps (axis of unit length). Priority: a wall under the
  /// pointer that faces along the axis, then the wall that a ray from `inside` along the axis meets, if it is near,
  /// then the grid.
  double face(const glm::dvec3& point, const glm::dvec3& axis, double offset, const glm::dvec3& inside);
  /// The same without walls.
  double grid(const glm::dvec3& point, const glm::dvec3& axis, double offset);
  /// Snaps every coordinate to the grid.
  glm::dvec3 grid(const glm::dvec3& point);

  SnapTarget target() const { return target_; }  ///< of the last result
  double gridStep() const { return step_; }      ///< scene units
  double turnStepDegrees() const { return turnStepDegrees_; }

 private:
  const SurfaceRays* surfaces_;
  Ray pointer_;
  double reach_, step_, turnStepDegrees_;
  SnapTarget target_ = SnapTarget::None;
};

}  // namespace boxprobe
