// What the programs of draws with shadowed lights are told: lights, the probes' coverage, maps of what moves. Called by
// the probe pass while it draws; the texts that read it are shaders/gpu/coverage*.glsl and moving_shadow.glsl.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/surface/uniform_upload.h"

namespace boxprobe {

void uploadCoverage(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding);

}  // namespace boxprobe
