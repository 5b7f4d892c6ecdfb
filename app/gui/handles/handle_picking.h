// Which handles there are, where they stand on the screen and which one is under the pointer; the ray through a pixel.
// Called by the probe widget and, for its answers, by tests. Knows a camera, no actors and no mouse buttons.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/gui/handles/handle.h"
#include "app/gui/handles/view_ray.h"
#include "filters/core/scene/scene.h"

class vtkCamera;

namespace boxprobe {

/// Of the selected probe those of `mode`; of the others the origins.
std::vector<Handle> handles(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                            HandleMode mode = HandleMode::Box);
/// Where a handle stands; of arrows and rings the middle of the gizmo.
glm::dvec3 handleAnchorWorld(const Probe& probe, const Handle& handle);
inline glm::dvec3 handlePositionWorld(const std::vector<Probe>& probes, const Handle& handle) {
  return handleAnchorWorld(probes[handle.probe], handle);
}
/// The way it goes, or the axis it turns about; unit length, out of the box for faces. Of Origin: up.
glm::dvec3 handleAxisWorld(const Probe& probe, const Handle& handle);

/// Logical pixels: arrows reach from here to there, rings have that radius.
constexpr double kArrowStartPixels = 24.0, kArrowPixels = 92.0, kRingPixels = 66.0;

/// A camera seen through a viewport of so many pixels. Pixels count from the top left; y grows downwards.
class ViewProjection {
 public:
  ViewProjection(vtkCamera* camera, double widthPixels, double heightPixels);

  /// Nothing for a point behind the viewer.
  std::optional<glm::dvec2> pixel(const glm::dvec3& pointWorld) const;
  Ray ray(const glm::dvec2& pixel) const;
  ViewAxes axes() const { return {forward_, up_}; }
  glm::dvec3 eyeWorld() const { return eye_; }
  glm::dvec3 right() const { return right_; }
  bool parallel() const { return parallel_; }
  /// World length of one pixel at that point.
  double metresPerPixel(const glm::dvec3& pointWorld) const;

 private:
  glm::dvec3 eye_, forward_, right_, up_;
  double halfHeight_;  ///< tangent of half the vertical field of view; half the height in a parallel projection
  double width_, height_;
  bool parallel_;
};

/// What of a handle the pointer has to come near to: a point, or the polyline of an arrow or a ring.
std::vector<glm::dvec3> handleGripWorld(const Probe& probe, const Handle& handle, const ViewProjection& view);

/// The handle that is nearest to `pixel` and not farther than `reachPixels`; of two as near, the one closer to the
/// viewer. Points come before lines.
std::optional<Handle> handleAt(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                               const ViewProjection& view, const glm::dvec2& pixel, double reachPixels,
                               HandleMode mode = HandleMode::Box);

}  // namespace boxprobe
