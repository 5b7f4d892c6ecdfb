// Uniforms of a surface itself: its material's textures and numbers, a planar mirror's picture over it, its glass.
// Called by the probe pass while it draws; the texts that read them are shaders/gpu/material.glsl, mirror_picture.glsl
// and glass.glsl.
#pragma once

#include "filters/vtk/draw/mirror_picture.h"
#include "filters/vtk/draw/pass_settings.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/scene_resources.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/uniform_upload.h"

namespace boxprobe {

void uploadMaterial(const UniformUpload& to, const SurfaceMaterial& surface);
void uploadMirror(const UniformUpload& to, const MirrorPicture& mirror, const SceneResources& resources);
/// `binding`: the probes that are looked up through the glass; `behind`: what the frame shows behind it.
void uploadGlassOf(const UniformUpload& to, const GlassSurface& glass, const ProbeBinding& binding,
                   const SceneResources& resources, const BehindPicture& behind);

}  // namespace boxprobe
