// The available handles, their positions, and the one under the pointer.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/handle.h"
#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {

/// For the selected probe those of `mode`; for others their origins.
std::vector<Handle> handles(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                            HandleMode mode = HandleMode::Box);
/// The position of a handle; for arrows and rings the centre of the gizmo.
glm::dvec3 handleAnchorWorld(const Probe& probe, const Handle& handle);
/// The direction of movement, or the axis of rotation; unit length, outwards for faces, up for Origin.
glm::dvec3 handleAxisWorld(const Probe& probe, const Handle& handle);

/// Logical pixels at size 1: start and end of arrows, radius of rings.
constexpr double kArrowStartPixels = 24.0, kArrowPixels = 92.0, kRingPixels = 66.0;

/// What the pointer has to be close to: a point, or the polyline of an arrow or ring, scaled by `size`.
std::vector<glm::dvec3> handleGripWorld(const Probe& probe, const Handle& handle, const ViewProjection& view,
                                        double size = 1.0);

/// The handle nearest to `pixel` within `reachPixels`; of equally near ones that closer to the viewer. Points have
/// priority over lines.
std::optional<Handle> handleAt(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                               const ViewProjection& view, const glm::dvec2& pixel, double reachPixels,
                               HandleMode mode = HandleMode::Box, double size = 1.0);

}  // namespace boxprobe
