// Shader source for a material's finish (MaterialFinish), and its edits of VTK's physically based shading.
#pragma once

#include <string>

#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/anchor_edits.h"

namespace boxprobe {

/// Defines that precede the probes' lighting; empty for a surface without a finish.
std::string finishSwitches(const SurfaceMaterial& surface);

/// shaders/gpu/finish.glsl and its dependencies; follows the material's declarations.
std::string finishDeclarations(const SurfaceMaterial& surface);

/// Edits VTK's text after the lighting's anchors and before those of coats and multiple scattering. `lamps`: number of
/// lamps in VTK's text; `probes`: probes and sky are sampled; `underCoat`: a clear coat reduces the light by
/// bpCoatPasses.
void spliceFinish(std::string& text, const SurfaceMaterial& surface, int lamps, bool probes, bool underCoat,
                  AnchorEdits& edits);

}  // namespace boxprobe
