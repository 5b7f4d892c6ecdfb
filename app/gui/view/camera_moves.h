// How a camera moves: about a point, towards a point, along an axis of the world, to see a box. Called by whatever
// moves the window's camera; plain mathematics on a vtkCamera that keeps the world's vertical upright.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "filters/core/geometry/probe_frame.h"
#include "filters/vtk/widgets/view_projection.h"

class vtkCamera;

namespace boxprobe {

glm::dvec3 eyeOf(vtkCamera* camera);
glm::dvec3 forwardOf(vtkCamera* camera);  ///< unit length
glm::dvec3 rightOf(vtkCamera* camera);    ///< unit length, horizontal unless the camera is tilted

/// Position and focal point.
void shiftCamera(vtkCamera* camera, const glm::dvec3& by);

/// Turns about `pivot`, which keeps its place in the picture: to the right by `yawDegrees` about the view-up axis,
/// raised by `pitchDegrees`, but never over the pole.
void turnCamera(vtkCamera* camera, const glm::dvec3& pivot, double yawDegrees, double pitchDegrees);

/// Towards what lies `distance` along `ray`, which keeps its pixel: `factor` times as near, and at least
/// `smallestStep`, which leads through a wall that is closer than that. The focal point keeps the direction of view and
/// comes to lie as deep as the point.
void zoomCamera(vtkCamera* camera, const Ray& ray, double distance, double factor, double smallestStep);

/// Sees all of `bounds`, world, from where it looks now. `aspect`: width over height.
void frameBox(vtkCamera* camera, const Box& bounds, double aspect);

/// Looks at the middle of `bounds` from the side of `face`, in parallel projection.
void lookAlong(vtkCamera* camera, const BoxFace& face, const Box& bounds, double aspect);

}  // namespace boxprobe
