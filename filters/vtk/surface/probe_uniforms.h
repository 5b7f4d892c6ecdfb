// Uniforms of the probes and the sky that a draw uses, relative to the camera, from double. Called by the probe pass
// while it draws; the texts that read them are shaders/gpu/probe_lighting.glsl and what probe_source.h writes for each
// slot.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/surface/resting_uniforms.h"
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
/// All that a program with probes reads of its lighting: surroundings, slots, coverage. Counted. `resting`: that
/// binding's lightingValues(), at least those that the program has not as `constants` (null: none). `flatMaps`: flat
/// pictures of the maps, as makeFlatMaps() has made them.
void uploadLighting(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug,
                    const RestingValues& resting, const RestingValues* constants = nullptr, bool flatMaps = false);

/// Makes the maps without lamps that rough surfaces look up, with the levels that the binding needs: before a draw
/// begins.
void makeLampFree(DrawState& state, const ProbeBinding& binding);
/// Flat pictures of what the binding looks up, those that are there apart, each counted. False: it is to be drawn by
/// cubemaps, since one of them has no such picture, or there is no memory for it.
bool makeFlatMaps(DrawState& state, const ProbeBinding& binding);

}  // namespace boxprobe
