// Which handles there are, where they stand on the screen and which one is under the pointer.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/handle.h"
#include "filters/vtk/widgets/view_projection.h"

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

/// Logical pixels at size 1: arrows reach from here to there, rings have that radius.
constexpr double kArrowStartPixels = 24.0, kArrowPixels = 92.0, kRingPixels = 66.0;

/// What of a handle the pointer has to come near to: a point, or the polyline of an arrow or a ring of `size` times
/// their usual pixels.
std::vector<glm::dvec3> handleGripWorld(const Probe& probe, const Handle& handle, const ViewProjection& view,
                                        double size = 1.0);

/// The handle that is nearest to `pixel` and not farther than `reachPixels`; of two as near, the one closer to the
/// viewer. Points come before lines.
std::optional<Handle> handleAt(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                               const ViewProjection& view, const glm::dvec2& pixel, double reachPixels,
                               HandleMode mode = HandleMode::Box, double size = 1.0);

}  // namespace boxprobe
