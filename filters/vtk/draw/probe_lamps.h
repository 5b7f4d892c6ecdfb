// The maps without lamps (maps/lamp_free_maps.h) that a binding's rough surface looks up. Called by the probe pass
// before a draw begins, with the window's context current.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"

namespace boxprobe {

/// Makes them, with the levels that the binding needs. Where there is no memory for one the probe's own is looked up.
void makeLampFree(const DrawState& state, const ProbeBinding& binding);

}  // namespace boxprobe
