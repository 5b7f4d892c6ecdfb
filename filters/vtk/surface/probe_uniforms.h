// Uniforms of the probes and the sky that a draw uses, relative to the camera, from double. Called by the mapper while
// it draws; the texts that read them are shaders/gpu/probe_lighting.glsl and what probe_source.h writes for each slot.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/surface/uniform_upload.h"

namespace boxprobe {

void uploadSplitSum(const UniformUpload& to, const SceneResources& resources);
/// That, the camera's axes, and the sky where the binding looks it up.
void uploadSurroundings(const UniformUpload& to, const SceneResources& resources, const ProbeBinding& binding);

/// The slots: maps, boxes, weights and parameters; `debug`: the debug view's own maps, too. Makes the blue-noise mask
/// if a technique wants it.
void uploadSlots(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug);

}  // namespace boxprobe
