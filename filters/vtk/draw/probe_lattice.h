// The lattice of diffuse light for drawing a probe (maps/lattice_maker.h): a capture waits for it; a window draws with
// the previous one until it is ready. Needs the window's context current.
#pragma once

#include <memory>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"

namespace boxprobe {

/// Null if the probe has none: its coefficients, which include lamps, are used instead.
std::shared_ptr<const DiffuseLattice> probeLattice(const DrawState& state, const DrawnProbe& probe);

}  // namespace boxprobe
