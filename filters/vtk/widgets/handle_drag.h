// What a drag of a handle makes of a mouse ray: always computed from where the drag began, never from the last move, so
// that nothing drifts and leaving a constraint brings the handle back under the pointer. Plain mathematics.
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

/// Along the line `point + t axis` (axis of unit length), the t that comes closest to the ray. Nothing if the ray runs
/// so nearly along the line (within 0.5 degrees) that a pixel would mean metres, or if they are closest behind the
/// viewer.
std::optional<double> closestOnLine(const Ray& ray, const glm::dvec3& point, const glm::dvec3& axis);

/// Where the ray meets the plane; nothing if it runs along it or meets it behind its origin.
std::optional<glm::dvec3> meetPlane(const Ray& ray, const glm::dvec3& point, const glm::dvec3& normal);

/// A point drawn along an axis.
class AxisDrag {
 public:
  AxisDrag(const glm::dvec3& point, const glm::dvec3& axis, const ViewAxes& view, const Ray& grab);
  /// How far along the axis it went. Where the ray says nothing about the axis the answer is the one before.
  double offset(const Ray& ray);
  const glm::dvec3& point() const { return point_; }
  const glm::dvec3& axis() const { return axis_; }

 private:
  std::optional<double> along(const Ray& ray) const;

  glm::dvec3 point_, axis_;
  ViewAxes view_;
  bool headOn_ = false;      ///< the axis points at the viewer: up on the screen means away from him
  double grabOffset_ = 0.0;  ///< from the point to where it was taken hold of
  double offset_ = 0.0;      ///< as last given
};

struct DragWish {
  Ray ray;
  bool symmetric = false;        ///< the opposite face goes as far the other way
  std::optional<int> axis = {};  ///< the origin goes along that world axis only
  DragSnap* snap = nullptr;
};

/// A drag of one handle of a probe.
class ProbeDrag {
 public:
  /// `thinnest`: faces of the projection box come no closer together, scene units.
  ProbeDrag(const Probe& probe, const Handle& handle, const ViewAxes& view, const Ray& grab,
            double thinnest = kMinimumThickness);
  /// The probe as the drag would leave it.
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
  double degrees_ = 0.0;    ///< of a ring, as last given
  glm::dvec3 originWorld_;  ///< as last given
};

/// Is it one that a face of a box hangs on?
bool isFace(const Handle& handle);
/// The probe with a handle moved by `by`, world: faces along their own axis alone, Move the whole probe, others its
/// origin.
Probe nudgedProbe(const Probe& probe, const Handle& handle, const glm::dvec3& by, const ViewAxes& view);

/// Moved along its box's X by tenths of its width until it stands on none of `others`: two in one place cannot be told
/// apart.
Probe besideOthers(const Probe& probe, const std::vector<Probe>& others);

/// The probe moved by `by`, world: its box, its influence box and its origin.
Probe movedProbe(const Probe& probe, const glm::dvec3& by);

/// Whether other probes that are selected too go along with a drag of that handle: where the whole probe or its origin
/// moves.
bool movesOthers(HandleKind kind);
/// Another probe that goes along while a drag of a handle of that kind makes `now` of `start`: moved as far, or turned
/// as far about the middle of the box of `start`.
Probe movedAlong(const Probe& other, HandleKind kind, const Probe& start, const Probe& now);

}  // namespace boxprobe
