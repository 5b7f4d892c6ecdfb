// Our own shader text of a material: varyings, samplers and factors of its textures, and what makes it glass. Written
// for the splice (vtk_pbr_splice.h); knows nothing of the text VTK writes, and no probe.
#pragma once

#include <string>
#include <vector>

#include "filters/vtk/draw/surface_facts.h"
#include "filters/vtk/draw/surface_material.h"

namespace boxprobe {

/// One varying from the vertices to the fragments: "bpUv0" is the attribute, bpUv0F what the fragment reads.
struct Varying {
  const char* type;
  const char* name;
  const char* value;  ///< in the vertex shader
};
std::vector<Varying> varyings(const SurfaceMaterial& surface);

/// What the anchors of a material refer to (BP_ROUGHNESS, BP_..._FACTOR and the like), with shaders/gpu/material.glsl;
/// what the facts make constant is so.
std::string materialDeclarations(const SurfaceMaterial& surface, SurfaceFacts facts);

/// shaders/gpu/glass.glsl and what it needs; after the probes' declarations.
std::string glassDeclarations(const GlassSurface& glass);

}  // namespace boxprobe
