// Shader text of a material's finish (MaterialFinish): which of it a program has, and where VTK's physically based
// shading takes it up. Written for the splice (vtk_pbr_splice.h).
#pragma once

#include <string>

#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/anchor_edits.h"

namespace boxprobe {

/// What probes' lighting is compiled with, before its own text; empty for a surface without a finish.
std::string finishSwitches(const SurfaceMaterial& surface);

/// shaders/gpu/finish.glsl and what it needs; after the material's declarations.
std::string finishDeclarations(const SurfaceMaterial& surface);

/// Edits VTK's text after the lighting's anchors and before those of coats and of multiple scattering. `lamps`: as many
/// as VTK has written in; `probes`: surroundings are looked up in probes and the sky; `underCoat`: a clear coat lets
/// through what it leaves by bpCoatPasses.
void spliceFinish(std::string& text, const SurfaceMaterial& surface, int lamps, bool probes, bool underCoat,
                  AnchorEdits& edits);

}  // namespace boxprobe
