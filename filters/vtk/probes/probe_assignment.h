// Which probes per object uses. CPU only, no GL.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/scene/model_actors.h"

namespace boxprobe {

/// The binding of one object: the probes whose influence box meets its bounds, most important first (equal importance
/// by name, never by the order in the file), at most ProbeBinding::kMaxProbesPerDraw. `drawn[i]` belongs to
/// scene.probes[i]; `meeting`: indices of those that meet the object (ProbeIndex).
std::shared_ptr<const ProbeBinding> assignProbes(const DrawnObject& object, const Scene& scene,
                                                 const std::vector<std::shared_ptr<DrawnProbe>>& drawn,
                                                 std::vector<std::size_t> meeting, bool probesEnabled, bool general);

}  // namespace boxprobe
