// Converts a mouse ray to the result of a drag. Always computed from the start of the drag, not from the last move:
// nothing drifts, and when a constraint is released the handle returns under the pointer.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/geometry/probe_frame.h"
#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/drag_snap.h"
#include "filters/vtk/widgets/handle.h"
#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {

/// The parameter t of the point on the line `point + t axis` (axis of unit length) that is closest to the ray. Nothing
/// if they are nearly parallel (within 0.5 degrees), where a pixel would mean metres, or if the point is behind the
/// viewer.
std::optional<double> closestOnLine(const Ray& ray, const glm::dvec3& point, const glm::dvec3& axis);

/// The intersection of ray and plane; nothing if they are parallel or it is behind the ray's origin.
std::optional<glm::dvec3> meetPlane(const Ray& ray, const glm::dvec3& point, const glm::dvec3& normal);

/// A drag of a point along an axis.
class AxisDrag {
 public:
  AxisDrag(const glm::dvec3& point, const glm::dvec3& axis, const ViewAxes& view, const Ray& grab);
  /// The distance along the axis. If the ray does not determine it, the previous result.
  double offset(const Ray& ray);
  const glm::dvec3& point() const { return point_; }
  const glm::dvec3& axis() const { return axis_; }

 private:
  std::optional<double> along(const Ray& ray) const;

  glm::dvec3 point_, axis_;
  ViewAxes view_;
  bool headOn_ = false;      ///< the axis points at the viewer: up on the screen means away from the viewer
  double grabOffset_ = 0.0;  ///< from the point to where it was grabbed
  double offset_ = 0.0;      ///< the last result
};

struct DragWish {
  Ray ray;
  bool symmetric = false;        ///< the opposite face moves equally far the other way
  std::optional<int> axis = {};  ///< restricts the origin to that world axis
  DragSnap* snap = nullptr;
};

/// A drag of one handle of a probe.
class ProbeDrag {
 public:
  /// `thinnest`: minimum distance of opposite faces of the projection box, scene units.
  ProbeDrag(const Probe& probe, const Handle& handle, const ViewAxes& view, const Ray& grab,
            double thinnest = kMinimumThickness);
  /// The resulting probe.
  Probe at(const DragWish& wish);
  const Handle& handle() const { return handle_; }
  const Probe& start() const { return start_; }

 private:
  Probe faceAt(const DragWish& wish);
  Probe movedAt(const DragWish& wish);
  Probe turnedAt(const DragWish& wish);
  Probe originAt(const DragWish& wish);
  double turnDegrees(const Ray& ray);

  Probe start_;
  Handle handle_;
  ViewAxes view_;
  Ray grab_;
  double thinnest_;
  AxisDrag line_;
  double degrees_ = 0.0;    ///< of a ring, the last result
  glm::dvec3 originWorld_;  ///< the last result
};

/// Is it a handle that moves a face of a box?
bool isFace(const Handle& handle);
/// The probe with a handle moved by `by`, world: faces along their own axis, Move the whole probe, others its origin.
Probe nudgedProbe(const Probe& probe, const Handle& handle, const glm::dvec3& by, const ViewAxes& view);

/// The probe moved by `by`, world: its box, its influence box and its origin.
Probe movedProbe(const Probe& probe, const glm::dvec3& by);

/// Do other selected probes follow a drag of that handle? They do if the whole probe or its origin moves.
bool movesOthers(HandleKind kind);
/// The result for another selected probe, if a drag of such a handle changes `start` to `now`: the same translation, or
/// the same rotation about the middle of the box of `start`.
Probe movedAlong(const Probe& other, HandleKind kind, const Probe& start, const Probe& now);

}  // namespace boxprobe
