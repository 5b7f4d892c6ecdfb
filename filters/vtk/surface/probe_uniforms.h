// Uniforms of a draw, relative to the camera, from double: the probes and the sky that light it, its material, the
// debug view. Uploaded by the probe pass while it draws; the texts that read them are shaders/gpu/probe_lighting.glsl
// and what probe_source.h writes for each slot, shaders/gpu/material.glsl and shaders/gpu/surface_view.glsl.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/mirror_picture.h"
#include "filters/vtk/draw/pass_settings.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/scene_resources.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/draw_numbers.h"
#include "filters/vtk/surface/uniform_upload.h"

namespace boxprobe {

void uploadSplitSum(const UniformUpload& to, const SceneResources& resources);

/// Exposure and projection: what every spliced program reads.
void uploadOutput(const UniformUpload& to, const PassSettings& pass);

/// All that a program with probes reads of its lighting: surroundings, numbers, slots, coverage. Counted. `constants`:
/// numbers that the program does not read (null: none). `flatMaps`: flat pictures of the maps, which are there.
void uploadLighting(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug,
                    const Constants* constants = nullptr, bool flatMaps = false);

/// Of the object that is drawn: the listed lights that reach it.
void uploadListedLights(const UniformUpload& to, ListedLights& listed);

void uploadMaterial(const UniformUpload& to, const SurfaceMaterial& surface);
void uploadMirror(const UniformUpload& to, const MirrorPicture& mirror, const SceneResources& resources);
/// `binding`: the probes that are looked up through the glass; `behind`: what the frame shows behind it.
void uploadGlassOf(const UniformUpload& to, const GlassSurface& glass, const ProbeBinding& binding,
                   const SceneResources& resources, const BehindPicture& behind);

/// Of the debug view's programs: which view, its range and colours. `object`: the number that a surface capture names
/// the object by.
void uploadView(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding, int object);

}  // namespace boxprobe
