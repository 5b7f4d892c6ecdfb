// Where the camera stands to see a probe or an object: indoors it stays on this side of the walls. Called by the view
// commands; knows no window.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/view_projection.h"

class vtkCamera;

namespace boxprobe {

/// Where a ray first meets what is shown; nothing where it goes into the sky. World.
using MeetSurface = std::function<std::optional<glm::dvec3>(const Ray&)>;

/// World bounds of a probe's turned box.
Box worldBoundsOf(const Probe& probe);

/// Is there a roof or a ceiling above that place?
bool isIndoors(const glm::dvec3& positionWorld, const MeetSurface& meet);

/// How far from the centre of `bounds` the eye may stand, the way `camera` looks at it, with no surface outside of
/// `bounds` in between; nothing if it may stand where it does. What stands in the inner four fifths of the way to the
/// bounds' edge, such as furniture, does not count.
std::optional<double> clearDistance(vtkCamera* camera, const Box& bounds, const MeetSurface& meet);

}  // namespace boxprobe
