// What a drag of a handle makes of a mouse ray: always computed from where the drag began, never from the last move, so
// that nothing drifts and leaving a constraint brings the handle back under the pointer. Called by the probe widget;
// plain mathematics that knows neither VTK nor Qt.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "filters/core/geometry/probe_frame.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Through a pixel, world space. `direction` has unit length.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// What the drags need of the view: unit vectors, world space.
struct ViewAxes {
  glm::dvec3 forward{0.0, 0.0, -1.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
};

/// Along the line `point + t axis` (axis of unit length), the t that comes closest to the ray. Nothing if the ray runs
/// so nearly along the line (within 0.5 degrees) that a pixel would mean metres, or if they are closest behind the
/// viewer.
std::optional<double> closestOnLine(const Ray& ray, const glm::dvec3& point, const glm::dvec3& axis);

/// Where the ray meets the plane; nothing if it runs along it or meets it behind its origin.
std::optional<glm::dvec3> meetPlane(const Ray& ray, const glm::dvec3& point, const glm::dvec3& normal);

/// Drag of one face along its own axis.
class FaceDrag {
 public:
  FaceDrag(const Probe& probe, const BoxFace& face, const ViewAxes& view, const Ray& grab);
  /// The box for the pointer on `ray`; `symmetric` moves the opposite face as far the other way. Where the ray says
  /// nothing about the axis the answer is the one before.
  Box box(const Ray& ray, bool symmetric);
  const BoxFace& face() const { return face_; }

 private:
  std::optional<double> alongAxis(const Ray& ray) const;

  Box start_;
  glm::dvec3 rotationDegrees_;
  BoxFace face_;
  glm::dvec3 centerWorld_;
  glm::dvec3 axisWorld_;
  ViewAxes view_;
  bool headOn_ = false;      ///< the axis points at the viewer: up on the screen means away from him
  double grabOffset_ = 0.0;  ///< along the axis, from the face to where it was taken hold of
  double offset_ = 0.0;      ///< as last given
};

/// Drag of the capture origin: in the plane through it that faces the camera, or along one world axis.
class OriginDrag {
 public:
  OriginDrag(const Probe& probe, const ViewAxes& view, const Ray& grab);
  glm::dvec3 origin(const Ray& ray, std::optional<int> axis);

 private:
  glm::dvec3 start_;
  glm::dvec3 planeNormal_;
  Ray grab_;
  glm::dvec3 last_;
};

}  // namespace boxprobe
