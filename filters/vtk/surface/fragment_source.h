// Our own shader text of a surface's fragments as a whole: what is declared before VTK's code, and what becomes of the
// colour at its end. Written for the splice (vtk_pbr_splice.h), which knows where in VTK's text it goes.
#pragma once

#include <string>

#include "filters/math/shared/display_math.h"
#include "filters/vtk/draw/light_form.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/surface_facts.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/surface_output.h"

namespace boxprobe {

/// What one program is written for.
struct SurfaceProgram {
  const ProbeBinding& binding;
  const SurfaceMaterial* surface;  ///< null: the material is VTK's own
  SurfaceOutput output;
  bool mirror;  ///< a planar mirror's picture is looked up
  LightForm form = LightForm::Single;
  SurfaceFacts facts = 0;  ///< what the program leaves out; needs `surface`
  /// Somebody else's actor: falloffs of lamps mean what they mean in VTK.
  bool foreign = false;
  /// Probes and sky are looked up in flat pictures of their maps (flat_texture.h).
  bool flatMaps = false;
  /// Emissive factors show without an emissive texture.
  bool emission = true;
  Tone tone = Tone::None;

  bool probes() const { return binding.lighting == Lighting::Probes; }
  bool debug() const { return output == SurfaceOutput::Debug; }
  /// Is the split-sum table read?
  bool table() const { return probes() || (form == LightForm::Multiple && binding.lighting == Lighting::Plain); }
  bool glass() const { return probes() && surface != nullptr && surface->glass.drawn; }
};

std::string fragmentDeclarations(const SurfaceProgram& program);

/// From the colour in linear light, by the name `color`, to what the program writes. `edges`: code that colours visible
/// edges, after the colour has been encoded.
std::string fragmentOutput(const SurfaceProgram& program, const std::string& edges);

}  // namespace boxprobe
