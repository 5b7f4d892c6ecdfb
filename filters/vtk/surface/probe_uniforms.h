// Uniforms of the probes and the sky that a draw uses, relative to the camera, from double. Called by the probe pass
// while it draws; the texts that read them are shaders/gpu/probe_lighting.glsl and what probe_source.h writes for each
// slot.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/surface/draw_numbers.h"
#include "filters/vtk/surface/uniform_upload.h"

namespace boxprobe {

void uploadSplitSum(const UniformUpload& to, const SceneResources& resources);
/// That, the camera's axes, and the sky where the binding looks it up.
void uploadSurroundings(const UniformUpload& to, const SceneResources& resources, const ProbeBinding& binding,
                        bool flatMaps = false);

/// Exposure and projection: what every spliced program reads.
void uploadOutput(const UniformUpload& to, const PassSettings& pass);

/// The slots' maps and origins; `debug`: the debug view's own maps, too. Makes the blue-noise mask
/// if a technique wants it.
void uploadSlots(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug,
                 bool flatMaps = false);
/// All that a program with probes reads of its lighting: surroundings, numbers, slots, coverage. Counted. `constants`:
/// numbers that the program does not read (null: none). `flatMaps`: flat pictures of the maps, which are there.
void uploadLighting(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug,
                    const Constants* constants = nullptr, bool flatMaps = false);

}  // namespace boxprobe
