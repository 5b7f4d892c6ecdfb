// The lattice of diffuse light that a probe is drawn with (maps/lattice_maker.h), as the pass asks for it: a capture
// waits for the right one, a window draws with what it had until the right one is there. Called when uniforms are
// uploaded and by explanations, with the window's context current.
#pragma once

#include <memory>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"

namespace boxprobe {

/// Null where the probe has none: its coefficients light instead, its lamps among them.
std::shared_ptr<const DiffuseLattice> probeLattice(const DrawState& state, const DrawnProbe& probe);

}  // namespace boxprobe
