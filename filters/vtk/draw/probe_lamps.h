// The maps without lamps (maps/lamp_free_maps.h) for the rough surface of a binding. To be called before a draw, with
// the window's context current.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"

namespace boxprobe {

/// Makes them with the levels that the binding needs. If memory is short, the probe's own map is sampled.
void makeLampFree(const DrawState& state, const ProbeBinding& binding);

}  // namespace boxprobe
