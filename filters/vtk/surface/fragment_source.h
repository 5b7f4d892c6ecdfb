// Our shader source for a surface's fragments: the declarations before VTK's code, and the output at its end.
// vtk_pbr_splice.h inserts it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "filters/math/shared/display_math.h"
#include "filters/vtk/draw/light_form.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/surface_facts.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/surface_output.h"

namespace boxprobe {

/// What one program is compiled for.
struct SurfaceProgram {
  const ProbeBinding& binding;
  const SurfaceMaterial* surface;  ///< null: VTK's own material code
  SurfaceOutput output;
  bool mirror;  ///< samples a planar mirror's picture
  LightForm form = LightForm::Single;
  SurfaceFacts facts = 0;  ///< what the program omits; requires `surface`
  /// An actor of another program: lamps have VTK's falloff.
  bool foreign = false;
  /// Samples flat pictures of the maps of probes and sky (flat_texture.h).
  bool flatMaps = false;
  /// Emissive factors apply without an emissive texture.
  bool emission = true;
  Tone tone = Tone::None;
  /// For each of the scene's lights its index in VTK's text; -1: in a list, which then takes the code of VTK's last
  /// one. Empty: the same indices, and no list.
  std::vector<int> lightPlaces = {};

  bool listsLights() const { return std::find(lightPlaces.begin(), lightPlaces.end(), -1) != lightPlaces.end(); }
  bool probes() const { return binding.lighting == Lighting::Probes; }
  bool debug() const { return output == SurfaceOutput::Debug; }
  /// Is the split-sum table sampled?
  bool table() const { return probes() || (form == LightForm::Multiple && binding.lighting == Lighting::Plain); }
  bool glass() const { return probes() && surface != nullptr && surface->glass.drawn; }
};

std::string fragmentDeclarations(const SurfaceProgram& program);

/// Converts linear light in `color` to the program's output. `edges`: code that colours visible edges, after the
/// encoding.
std::string fragmentOutput(const SurfaceProgram& program, const std::string& edges);

}  // namespace boxprobe
