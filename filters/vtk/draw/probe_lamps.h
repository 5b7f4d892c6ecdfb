// The maps without lamps (maps/lamp_free_maps.h) for the rough surface of a binding, and what its lamps give beside
// them. To be called before a draw, with the window's context current.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"

namespace boxprobe {

/// Makes them with the levels that the binding needs. If memory is short, the probe's own map is sampled.
void makeLampFree(const DrawState& state, const ProbeBinding& binding);

/// What a lamp's shape gives in reflections: its radiance, less what stands in its place in the maps without lamps of
/// the binding's probes, to which it is added, the mean over the probes.
glm::vec3 lampReflected(const DrawState& state, const ProbeBinding& binding, std::size_t lamp);

}  // namespace boxprobe
