// Shader source for a material: varyings, samplers and factors of its textures, and glass. vtk_pbr_splice.h inserts it.
#pragma once

#include <string>
#include <vector>

#include "filters/vtk/draw/surface_facts.h"
#include "filters/vtk/draw/surface_material.h"

namespace boxprobe {

/// A varying: "bpUv0" is the attribute, bpUv0F the fragment's input.
struct Varying {
  const char* type;
  const char* name;
  const char* value;  ///< expression in the vertex shader
};
std::vector<Varying> varyings(const SurfaceMaterial& surface);

/// The names that a material's anchors use (BP_ROUGHNESS, BP_..._FACTOR and the like), and shaders/gpu/material.glsl;
/// values that facts determine are constants.
std::string materialDeclarations(const SurfaceMaterial& surface, SurfaceFacts facts);

/// shaders/gpu/glass.glsl and its dependencies; follows the probes' declarations.
std::string glassDeclarations(const GlassSurface& glass);

}  // namespace boxprobe
