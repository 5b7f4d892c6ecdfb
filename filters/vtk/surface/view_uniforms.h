// Uniforms of the debug view's programs: which view, its range and colours. Called by the probe pass while it draws;
// the text that reads them is shaders/gpu/surface_view.glsl.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/surface/uniform_upload.h"

namespace boxprobe {

/// `object`: the number that a surface capture names the object by.
void uploadView(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding, int object);

}  // namespace boxprobe
